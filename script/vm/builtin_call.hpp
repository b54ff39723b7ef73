// What a built-in gets, and the helpers that most of them need: arguments by
// type, with errors that name the function and the argument (language
// rule 8.1).
#pragma once

#include <cstdint>
#include <string>

#include "script/vm/machine.hpp"

namespace parlour::script {

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

  // Always false: the built-in has failed.
  bool fail(ErrorKind kind, const std::string& message);
  bool wrong_type(std::size_t index, const char* wanted);

  // False: raised. Numbers and booleans become text where it is wanted.
  bool text(std::size_t index, std::string& value);
  // The same as a string, which stands in the argument's place then; null:
  // raised.
  const StringObject* string(std::size_t index);
  bool integer(std::size_t index, std::int64_t& value);
  bool number(std::size_t index, Numeric& value);
  bool list(std::size_t index, ListObject*& value);

  // Ends the built-in well.
  bool give(Box value);
  bool give_text(const std::string& value); // checks limits.result
  bool give_integer(std::int64_t value);
  bool give_number(double value);
  bool give_flag(bool value);

  // Work of this many bytes or elements; false: out of fuel, raised.
  bool work(std::size_t bytes);
  // The same of boxes compared or searched.
  bool looked_at(std::size_t boxes) {
    return machine.charge(boxes / Machine::boxes_per_unit);
  }
  // Room for a result of this many bytes; false: raised.
  bool room(std::size_t bytes);
};

} // namespace parlour::script
