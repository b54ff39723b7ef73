// Converts the number of an argument to decimal digits.
// Numbers of built-in functions as decimal digits.
#pragma once

#include "runtime/base/text/decimal.hpp"
#include "script/values/operations.hpp"

namespace parlour::script {

inline Decimal decimal_of(const Numeric& number) {
  return number.is_integer ? parlour::decimal_of(number.integer)
                           : parlour::decimal_of(number.number);
}

} // namespace parlour::script
