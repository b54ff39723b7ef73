// BuiltinCall: what a built-in function receives, with helpers that most of
// them need. Arguments are read by type; an error names the function and the
// argument (language rule 8.1).
//
//   bool repeat(BuiltinCall& call) { // repeat(text, count)
//     std::string text;
//     std::int64_t count = 0;
//     if (!call.text(0, text) || !call.integer(1, count))
//       return false; // the error was raised
//     …
//     return call.give_text(repeated);
//   }
#pragma once

#include <cstdint>
#include <string>

#include "script/vm/machine.hpp"

namespace parlour::script {

// Valid during the call only. The arguments are registers of the caller.
struct BuiltinCall {
  Machine& machine;
  const char* name;
  Box* arguments;
  std::size_t count;
  Box& result;

  const Box& operator[](std::size_t index) const {
    return arguments[index];
  }
  bool has(std::size_t index) const {
    return index < count;
  }
  Heap& heap() {
    return machine.heap();
  }

  // Raise an error; they always return false, as does a built-in that failed.
  bool fail(ErrorKind kind, const std::string& message);
  bool wrong_type(std::size_t index, const char* wanted);

  // Read an argument, which costs fuel by its size. They return false after
  // raising an error. Numbers and booleans become text where text is wanted.
  bool text(std::size_t index, std::string& value);
  // Reads an argument as a string object without copying it. Another value is
  // printed into a string that replaces the argument. Null after an error.
  const StringObject* string(std::size_t index);
  bool integer(std::size_t index, std::int64_t& value);
  bool number(std::size_t index, Numeric& value);
  // Nothing if it is no number.
  bool perhaps_number(std::size_t index, std::optional<Numeric>& value);
  bool list(std::size_t index, ListObject*& value);

  // Appends the printed form of any value, up to limits.result.
  bool print(std::string& text, const Box& value);

  // Return the result; the built-in ends with `return call.give…`.
  bool give(Box value);
  bool give_text(const std::string& value); // checks limits.result
  bool give_integer(std::int64_t value);
  bool give_number(double value);
  bool give_flag(bool value);

  // To be called before an argument, a list or map, is changed in place
  // (Machine::writes).
  void changes() {
    ++machine.writes;
  }

  // Charge fuel by the price of WalkBudget (language rule 9.6). False after
  // raising an error: the fuel is used up.
  bool bytes(std::size_t number) {
    return machine.charge_bytes(number);
  }
  bool values(std::size_t number) {
    return machine.charge_values(number);
  }
  // The same for a walk; an exhausted budget is an error, too.
  bool pay(const WalkBudget& budget);
  // Checks that a result of this many bytes is within the limits; false after
  // raising an error.
  bool room(std::size_t bytes);
};

} // namespace parlour::script
