// The names of all elements of a list, as an error message lists the choices.
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
