#include "runtime/base/text/decimal.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string_view>

namespace parlour {

namespace {

// Reads what std::to_chars wrote, such as "-1.25e+07" or "12". The mantissa's
// point gives the position, which the exponent then moves.
Decimal from_text(std::string_view text) {
  Decimal decimal;
  decimal.negative = text.starts_with('-');
  const auto exponent = std::min(text.find('e'), text.size());
  const auto mantissa =
      text.substr(decimal.negative, exponent - decimal.negative);
  decimal.point =
      static_cast<int>(std::min(mantissa.find('.'), mantissa.size()));
  for (const char c : mantissa)
    if (c != '.')
      decimal.digits += c;
  if (exponent < text.size())
    decimal.point += std::atoi(text.data() + exponent + 1);
  return decimal;
}

// Restores the invariant of Decimal: no zero at either end of the digits.
Decimal without_zeros(Decimal decimal) {
  auto& digits = decimal.digits;
  const auto first = std::min(digits.find_first_not_of('0'), digits.size());
  digits.erase(0, first);
  decimal.point -= static_cast<int>(first);
  digits.erase(digits.find_last_not_of('0') + 1);
  return digits.empty() ? Decimal() : decimal;
}

// The buffer is zero-initialised and one byte larger than to_chars may use, so
// what it wrote ends with a null character.
template <class Number, class... Format>
Decimal written(Number number, Format... format) {
  std::array<char, 32> buffer{};
  std::to_chars(buffer.data(), buffer.data() + buffer.size() - 1, number,
                format...);
  return without_zeros(from_text(buffer.data()));
}

constexpr int max_plain_digits = 21; // before the point
constexpr int max_plain_zeros = 5;   // behind it

std::string with_exponent(const Decimal& decimal) {
  auto text = decimal.digits;
  if (text.size() > 1)
    text.insert(1, 1, '.');
  const auto exponent = decimal.point - 1;
  return text + (exponent < 0 ? "e" : "e+") + std::to_string(exponent);
}

std::string plain(const Decimal& decimal) {
  const auto fraction = fraction_digits(decimal);
  return whole_digits(decimal) + (fraction.empty() ? "" : "." + fraction);
}

// The zeros between the point and the first digit.
std::string leading_zeros(const Decimal& decimal) {
  return std::string(static_cast<std::size_t>(std::max(-decimal.point, 0)),
                     '0');
}

} // namespace

Decimal decimal_of(std::int64_t number) {
  return written(number);
}

Decimal decimal_of(double number) {
  return written(number, std::chars_format::scientific);
}

// Keeps `point + places` digits and carries a one to the left where the first
// digit that is cut is 5 or more.
Decimal rounded(Decimal decimal, int places) {
  // The number of digits that remain.
  const auto kept = decimal.point + places;
  if (kept >= static_cast<int>(decimal.digits.size()))
    return decimal;
  if (kept < 0)
    return {};
  auto& digits = decimal.digits;
  const bool up = digits[static_cast<std::size_t>(kept)] >= '5';
  digits.resize(static_cast<std::size_t>(kept));
  digits.insert(0, 1, '0'); // room for a carry
  ++decimal.point;
  auto last = digits.rbegin();
  for (; up && *last == '9'; ++last)
    *last = '0';
  *last = static_cast<char>(*last + up);
  return without_zeros(decimal);
}

std::string decimal_text(const Decimal& decimal) {
  const bool is_plain =
      decimal.point <= max_plain_digits && decimal.point >= -max_plain_zeros;
  return (decimal.negative ? "-" : "") +
         (is_plain ? plain(decimal) : with_exponent(decimal));
}

std::string whole_digits(const Decimal& decimal) {
  if (decimal.point <= 0)
    return "0";
  auto whole = decimal.digits;
  whole.resize(static_cast<std::size_t>(decimal.point), '0');
  return whole;
}

std::string fraction_digits(const Decimal& decimal) {
  const auto whole = static_cast<std::size_t>(std::max(decimal.point, 0));
  if (whole >= decimal.digits.size())
    return {};
  return leading_zeros(decimal) + decimal.digits.substr(whole);
}

} // namespace parlour
