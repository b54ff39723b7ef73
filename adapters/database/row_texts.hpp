// RowTexts: the texts of one row share a piece of memory, as a row is mostly
// let go of as a whole. Who keeps one of them keeps those of the same row.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "runtime/base/value.hpp"

namespace parlour::adapters {

class RowTexts {
public:
  // Of at most so many; takes memory with the first.
  explicit RowTexts(std::size_t most) : most_(most) {}

  // What is not UTF-8 becomes U+FFFD.
  Value add(std::string_view bytes);

private:
  std::size_t most_;
  std::size_t count_ = 0;
  std::shared_ptr<std::string[]> texts_;
};

} // namespace parlour::adapters
