// Decimal: the decimal digits of a number. Printing (language rule 2.2),
// formatting (8.13) and speaking (8.12) a number all start from them.
#pragma once

#include <cstdint>
#include <string>

namespace parlour {

// The value is 0.DIGITS * 10^point, with a sign: digits "125" and point 1 mean
// 1.25; digits "5" and point -2 mean 0.005.
struct Decimal {
  bool negative = false;
  std::string digits; // no zero at either end; empty for zero
  int point = 0;      // position of the point; may be outside of digits

  bool operator==(const Decimal&) const = default;
};

Decimal decimal_of(std::int64_t number);
// The shortest digits that read back as the same double. The number must be
// finite.
Decimal decimal_of(double number);

// Rounded to at most `places` digits after the point; halves go away from zero.
Decimal rounded(Decimal decimal, int places);

// Plain notation for numbers below 1e21 and from 1e-6 on, else with an
// exponent.
std::string decimal_text(const Decimal& decimal);

// The digits before the point ("0" if there are none) and those after it.
std::string whole_digits(const Decimal& decimal);
std::string fraction_digits(const Decimal& decimal);

} // namespace parlour
