// The patterns of the built-in format(): text with the places {} and {:…}
// (language rule 8.13). A pattern is parsed once into pieces; each place is
// then filled with a value.
//
//   format('{:05}', 42)         00042
//   format('{:>6}|', 'ab')          ab|
//   format('{:*^6}', 'ab')      **ab**
//   format('{:,.2}', 1234.5)    1,234.50
//   format('{:+}', 3)           +3
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/text/decimal.hpp"

namespace parlour::script {

// What is behind the colon: [[fill]align][+][0][width][,][.decimals][case].
struct Format {           // one character of any length in bytes
  std::string fill = " "; // < > ^; 0: numbers right, others left
  char align = 0;         // + before numbers that are not negative
  bool sign = false;      // fill with zeros between sign and digits
  bool zeros = false;     // fill the width behind the sign
  bool thousands = false;
  std::size_t width = 0; // in characters
  std::optional<int> decimals;
  char letters = 0; // u: upper, l: lower, c: first letter upper

  // Whether it can be applied to numbers only.
  bool needs_number() const {
    return sign || zeros || thousands || decimals;
  }
};

// A stretch of text and the place behind it.
struct FormatPiece {
  std::string text;             // before the place
  std::optional<Format> format; // nothing in the last piece
};

struct FormatPattern {
  std::vector<FormatPiece> pieces;
  std::size_t places = 0; // that take a value
  std::string error;      // empty: the pattern is correct
};

// The compiler uses it to check constant patterns, and the built-in to apply
// them.
FormatPattern parse_format(std::string_view pattern);

// The digits of a number by its format, padded with zeros only.
std::string formatted(const Decimal& number, const Format& format);
// Applies letter case and padding to a text that is complete otherwise.
std::string laid_out(std::string text, const Format& format, bool is_number);

} // namespace parlour::script
