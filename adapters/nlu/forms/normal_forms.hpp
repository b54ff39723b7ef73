// Times, dates, numbers and the like in an utterance, as the values that the
// rest of the platform calculates with:
//
//   time      "10:30" (24 hours); hours that an office does not work are
//             taken for the afternoon: "at three" is 15:00
//   date      "2026-11-21"
//   number    an integer, or a number with a point
//   duration  seconds
//   level     an integer: ground or first floor 1, basement one -1
//   phone     digits, perhaps after a "+"
//   email     lower case
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

inline constexpr std::size_t form_count = 7;

// The form of that name, as slots' cardinalities and `@time` write it.
std::optional<Form> form_of(std::string_view name);
std::string_view name_of(Form form);

struct FormAt {
  Value value;
  std::size_t length = 0; // tokens
  // Only taken where such a value is expected: a bare "four" for a time.
  bool weak = false;
};

// Unknown: what depends on the time of day or the date is not understood.
using Now = std::optional<Timestamp>;

// The longest such value that begins at this token.
std::optional<FormAt> form_at(Form form, const Tokens& tokens,
                              std::size_t position, Now now);

} // namespace parlour::adapters::nlu
