// The figures of a built-in's argument.
#pragma once

#include "runtime/base/decimal.hpp"
#include "script/values/operations.hpp"

namespace parlour::script {

inline Decimal decimal_of(const Numeric& number) {
  return number.is_integer ? parlour::decimal_of(number.integer)
                           : parlour::decimal_of(number.number);
}

} // namespace parlour::script
