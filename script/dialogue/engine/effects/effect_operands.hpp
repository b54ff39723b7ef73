// Short ways to read the operands of an effect (script/program/effects.def).
#pragma once

#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::dialogue {

// What takes several values also takes one by itself; unknown is none.
inline List list_of(const Value& value) {
  if (const auto* list = value.if_list())
    return *list;
  return value.is_unknown() ? List{} : List{value};
}

// Durations are operands in milliseconds (script/program/effects.def).
inline Milliseconds milliseconds(const Value& value) {
  return Milliseconds(value.integer_or(0));
}

inline std::string text_or(const Value& value, const char* otherwise) {
  return value.is_unknown() ? otherwise : value.text();
}

// For names that are computed; constant ones are checked by the compiler.
inline Error missing(const char* what, const Value& name) {
  return {ErrorKind::range,
          std::string("there is no ") + what + " '" + name.text() + "'",
          {}};
}

} // namespace parlour::dialogue
