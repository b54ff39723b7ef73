// RowTexts allocates all texts of one row of a result in one block. A row is
// mostly released as a whole, so one allocation replaces one per cell. The
// price: a script that keeps a single text keeps the texts of the whole row in
// memory.
//
// A RowTexts may be destroyed before the values that it made: they share the
// ownership of the block. Not thread-safe.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "runtime/base/value.hpp"

namespace parlour::adapters {

class RowTexts {
public:
  // `max_count` is the largest number of texts, usually the number of columns.
  // Memory is allocated with the first text.
  explicit RowTexts(std::size_t max_count) : max_count_(max_count) {}

  // Copies the bytes into a text. Bytes that are not valid UTF-8 become U+FFFD.
  Value add(std::string_view bytes);

private:
  std::size_t max_count_;
  std::size_t count_ = 0;
  std::shared_ptr<std::string[]> texts_;
};

} // namespace parlour::adapters
