// Decimal: the figures of a number, from which it is printed, formatted and
// spoken (language rule 2.2).
#pragma once

#include <cstdint>
#include <string>

namespace parlour {

struct Decimal {
  bool negative = false;
  std::string digits; // no zero at either end; empty: the number is zero
  int point = 0;      // how many of the digits stand before it; may be outside

  bool operator==(const Decimal&) const = default;
};

Decimal decimal_of(std::int64_t number);
// The fewest digits that read back as the same number, which must be finite.
Decimal decimal_of(double number);

// With so many digits after the point at most; halves away from zero.
Decimal rounded(Decimal decimal, int places);

// Plain figures up to 1e21; with an exponent beyond, and below 1e-6.
std::string decimal_text(const Decimal& decimal);

// "0" or what stands before the point, and what stands behind it.
std::string whole_digits(const Decimal& decimal);
std::string fraction_digits(const Decimal& decimal);

} // namespace parlour
