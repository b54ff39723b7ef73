// What is known by the names of elements, which are equal without regard to
// the case of their first letter (language rule 1.4).
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>

#include "script/source/source.hpp"

namespace parlour::script {

struct NameHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view name) const;
};

struct NameEqual {
  using is_transparent = void;
  bool operator()(std::string_view a, std::string_view b) const {
    return same_name(a, b);
  }
};

template <class T>
using ByName = std::unordered_map<std::string, T, NameHash, NameEqual>;

} // namespace parlour::script
