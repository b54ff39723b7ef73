// Built-in functions for time (language rule 8.8). They use the clock of the
// host only.
#include <cmath>

#include "runtime/base/clock.hpp"
#include "script/vm/builtin_call.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script::builtins {

namespace {

constexpr double latest = 253402300799; // the end of the year 9999

// The first argument is a pattern, the second a time in seconds since 1970;
// both are optional.
bool formatted(BuiltinCall& call, const char* pattern) {
  std::string given;
  if (call.has(0) && !call[0].is_unknown()) {
    if (!call.text(0, given))
      return false;
    pattern = given.c_str();
  }
  // Without a time the present one.
  auto at = call.machine.host->now();
  if (call.has(1)) {
    Numeric seconds;
    if (!call.number(1, seconds))
      return false;
    if (std::abs(seconds.as_number()) > latest)
      return call.fail(ErrorKind::range, "the time is out of the calendar");
    at = static_cast<Timestamp>(std::floor(seconds.as_number() * 1000));
  }
  return call.room(given.size()) &&
         call.give_text(format_timestamp(at, pattern));
}

} // namespace

// An integer if there are no milliseconds.
bool now(BuiltinCall& call) {
  const auto milliseconds = call.machine.host->now();
  if (milliseconds % 1000 == 0)
    return call.give_integer(milliseconds / 1000);
  return call.give_number(static_cast<double>(milliseconds) / 1000);
}

// date() and time() differ in their default pattern only.
bool date(BuiltinCall& call) {
  return formatted(call, "%Y-%m-%d");
}

bool time(BuiltinCall& call) {
  return formatted(call, "%H:%M");
}

} // namespace parlour::script::builtins
