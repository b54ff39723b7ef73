// Finds times, dates, numbers and the like in an utterance and converts them to
// the values with which the rest of the platform calculates. What is read is
// described in docs/understanding.md; tests/adapters/nlu/forms.txt has
// examples.
//
//  time      "10:30" (24 hours). An hour before eight is in the afternoon, if
//            nothing is said about it: "at three" is 15:00
//  date      "2026-11-21"
//  number    an integer, or a number with a decimal point
//  duration  seconds
//  level     an integer: ground floor and first floor 1, basement one -1
//  phone     digits, perhaps after a "+"
//  email     lower case
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "adapters/nlu/text/tokens.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters::nlu {

enum class Form : std::uint8_t {
  time,
  date,
  number,
  duration,
  phone,
  email,
  level,
};

// The number of forms above.
inline constexpr std::size_t form_count = 7;

// The form of a name, as cardinalities of slots ("time") and grammars (`@time`)
// write it.
std::optional<Form> form_of(std::string_view name);
std::string_view name_of(Form form);

// A value that was found.
struct FormAt {
  Value value;
  // In tokens.
  std::size_t length = 0;
  // The value counts only where one of its form is expected: "four" can be a
  // time.
  bool weak = false;
};

// The clock of the conversation. Without it, forms that depend on the current
// time or date are not understood.
using Now = std::optional<Timestamp>;

// The value of this form that begins at `position`, in its longest reading.
std::optional<FormAt> form_at(Form form, const Tokens& tokens,
                              std::size_t position, Now now);

} // namespace parlour::adapters::nlu
