// The names of a list of things that have one: to say what there is instead of
// what was asked for.
#pragma once

#include <string>
#include <vector>

namespace parlour {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const auto& one : all)
    names.push_back(one.name);
  return names;
}

} // namespace parlour
