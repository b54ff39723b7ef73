// ByName: a hash map whose keys are names of elements. Two names are the same
// if they differ in the case of the first letter only (language rule 1.4).
//
// <Print> and <print> are one key; <PRINT> is another.
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

// Both functors are transparent, so a lookup by string_view makes no string.
struct NameEqual {
  using is_transparent = void;
  bool operator()(std::string_view a, std::string_view b) const {
    return same_name(a, b);
  }
};

template <class T>
using ByName = std::unordered_map<std::string, T, NameHash, NameEqual>;

} // namespace parlour::script
