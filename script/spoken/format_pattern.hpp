// The pattern of format(): texts with {} and {:…} in between (language rule
// 8.13).
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/decimal.hpp"

namespace parlour::script {

// What stands behind the colon: [[fill]align][+][0][width][,][.decimals][case].
struct Format {
  std::string fill = " "; // one character
  char align = 0;         // < > ^; 0: numbers to the right, others to the left
  bool sign = false;      // + before what is not negative
  bool zeros = false;     // up to the width, behind the sign
  bool thousands = false;
  std::size_t width = 0; // in characters
  std::optional<int> decimals;
  char letters = 0; // u: capitals, l: small, c: the first one a capital

  bool needs_number() const {
    return sign || zeros || thousands || decimals;
  }
};

struct FormatPiece {
  std::string text;             // what stands before it
  std::optional<Format> format; // the last piece may have none
};

struct FormatPattern {
  std::vector<FormatPiece> pieces;
  std::size_t places = 0; // that take a value
  std::string error;      // what is wrong with it
};

FormatPattern parse_format(std::string_view pattern);

// The figures, without padding but for zeros.
std::string formatted(const Decimal& number, const Format& format);
// Letters and padding.
std::string laid_out(std::string text, const Format& format, bool is_number);

} // namespace parlour::script
