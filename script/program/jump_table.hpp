// JumpTable: finds the arm of a <switch>, or of a chain of conditions on one
// variable, by the value itself instead of testing one constant after the
// other. The constants are either all strings or all integers. Immutable once
// compiled, so all sessions share it.
#pragma once

#include <cstdint>
#include <vector>

#include "script/values/box.hpp"

namespace parlour::script {

// A hash table with open addressing.
class JumpTable {
public:
  static bool may_hold(const Box& constant) {
    return constant.is_string() || constant.is_small();
  }
  // Adds an arm. The constant must be of the same type as the others. Of equal
  // constants the first counts. `target` is the index of an instruction.
  void add(const Box& constant, std::uint32_t target);
  // Where a value without an arm continues.
  void otherwise(std::uint32_t target) {
    otherwise_ = target;
  }

  // The target for a value, which must not be a bound parameter. Null if the
  // value is not of the table's type: then only the tests themselves can
  // decide, as '5' equals 5.
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

  // The number of places is a power of two, and at most half of them are used.
  std::vector<Entry> entries_ = std::vector<Entry>(8);
  std::size_t used_ = 0;
  bool of_strings_ = false;
  std::uint32_t otherwise_ = 0;
};

} // namespace parlour::script
