// TextMap: a hash table whose keys are texts, in which a string_view is looked
// up without a copy. It has no order: what is shown of it is sorted.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace parlour {

struct TextHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view text) const {
    return std::hash<std::string_view>()(text);
  }
};

template <class Value>
using TextMap =
    std::unordered_map<std::string, Value, TextHash, std::equal_to<>>;

} // namespace parlour
