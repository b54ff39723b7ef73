// ManyValues: the value of a slot with several values (engine rule 5.14): a
// list of {value, amount}. Pure.
#pragma once

#include "runtime/base/value.hpp"

namespace parlour::dialogue {

// Values are told apart by equality; each is there at most once. An amount is a
// number, and 1 where nothing was said.
class ManyValues {
public:
  ManyValues() = default;
  // As a slot holds it; what is no list of values has none.
  explicit ManyValues(const Value& held);

  // A value with its amount; unknown: one, or as many as there were. `more`: so
  // many in addition. "Two teas" -> 2; then "another tea" -> 3.
  void put(const Value& value, const Value& amount, bool more);
  // What was said last becomes this one instead.
  void replace_last(const Value& value, const Value& amount);
  // So many of it; unknown, or as many as there are: all. Whether it was there.
  bool remove(const Value& value, const Value& amount);

  bool has(const Value& value) const;
  bool empty() const {
    return items_.empty();
  }
  Value take(); // unknown where there is none

private:
  List items_;
};

} // namespace parlour::dialogue
