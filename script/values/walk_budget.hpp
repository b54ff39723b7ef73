// WalkBudget: what it costs to walk through something large, and how far an
// operation may still go. All work beyond that of an instruction itself has
// this one price (language rule 9.6): 32 bytes are an instruction, and a value
// that is looked at, compared or copied counts as eight bytes.
//
// An operation takes from a budget what it visits and stops when that is
// exhausted; the machine charges afterwards what was taken. So values that
// share parts so often that a walk would take for ever do no harm:
//
//   auto budget = machine.walk_budget();
//   const bool same = equal(left, right, budget);
//   return machine.pay(budget) && …
#pragma once

#include <cstddef>

namespace parlour::script {

class WalkBudget {
public:
  static constexpr std::size_t bytes_per_instruction = 32;
  static constexpr std::size_t bytes_per_value = 8;

  // The price of work on this many bytes, or values.
  static constexpr std::size_t price_of_bytes(std::size_t count) {
    return count / bytes_per_instruction;
  }
  static constexpr std::size_t price_of_values(std::size_t count) {
    return count / (bytes_per_instruction / bytes_per_value);
  }

  explicit WalkBudget(std::size_t bytes) : given_(bytes), left_(bytes) {}

  // Take from the budget. False if it does not suffice; it is exhausted then.
  bool bytes(std::size_t count) {
    exhausted_ = exhausted_ || count > left_;
    left_ -= exhausted_ ? left_ : count;
    return !exhausted_;
  }
  bool values(std::size_t count = 1) {
    return bytes(count * bytes_per_value);
  }
  // Gives up a walk for another reason, such as values nested too deep.
  void exhaust() {
    exhausted_ = true;
    left_ = 0;
  }

  bool exhausted() const {
    return exhausted_;
  }
  std::size_t left() const { // bytes
    return left_;
  }
  // The price of what was taken, in instructions.
  std::size_t price() const {
    return price_of_bytes(given_ - left_);
  }

private:
  std::size_t given_;
  std::size_t left_;
  bool exhausted_ = false;
};

} // namespace parlour::script
