// JumpTable: where the arms of a switch, or of a chain of conditions, begin
// whose values are constants; found by the value itself instead of by one test
// after another. Either all strings or all integers. Immutable once compiled.
#pragma once

#include <cstdint>
#include <vector>

#include "script/values/box.hpp"

namespace parlour::script {

class JumpTable {
public:
  static bool may_hold(const Box& constant) {
    return constant.is_string() || constant.is_small();
  }
  // A constant of the type of all others, and an instruction's number; the
  // first of equal constants counts.
  void add(const Box& constant, std::uint32_t target);
  // Where a value that no arm has goes on.
  void otherwise(std::uint32_t target) {
    otherwise_ = target;
  }

  // The arm of a value that is no reference; null where it is not of the
  // table's type, so that only the tests know ('5' == 5).
  const std::uint32_t* find(const Box& value) const;

  struct Entry {
    Box constant; // unknown: free
    std::uint32_t target = 0;
  };
  const std::vector<Entry>& entries() const {
    return entries_;
  }
  std::uint32_t otherwise() const {
    return otherwise_;
  }

private:
  std::size_t slot_of(const Box& value) const;
  void grow();

  // A power of two of them, at most half in use.
  std::vector<Entry> entries_ = std::vector<Entry>(8);
  std::size_t used_ = 0;
  bool of_strings_ = false;
  std::uint32_t otherwise_ = 0;
};

} // namespace parlour::script
