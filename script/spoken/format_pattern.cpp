// Parsing of patterns, and applying a format to one value. Two readers:
// PatternReader finds the places, Reader reads the format of one place.

#include "script/spoken/format_pattern.hpp"

#include <algorithm>
#include <charconv>

#include "script/spoken/letter_case.hpp"
#include "script/values/objects.hpp"
#include "script/values/operations.hpp"

namespace parlour::script {

namespace {

constexpr std::size_t max_width = 1000;
constexpr int max_decimals = 20;
// Larger numbers are all reported alike, so reading stops growing here.
constexpr std::size_t out_of_bounds = 1'000'000;
constexpr std::string_view aligns = "<>^";
constexpr std::string_view cases = "ulc";

// Reads a format from left to right. Every part is optional; what remains
// unread is an error of the caller.
class Reader {
public:
  explicit Reader(std::string_view text) : rest_(text) {}

  Format read() {
    Format format;
    read_align(format);
    format.sign = skip('+');
    format.zeros = skip('0');
    format.width = number();
    format.thousands = skip(',');
    if (skip('.'))
      format.decimals = digits() ? static_cast<int>(number()) : -1;
    if (!rest_.empty() && cases.find(rest_[0]) != std::string_view::npos) {
      format.letters = rest_[0];
      rest_.remove_prefix(1);
    }
    return format;
  }
  bool done() const {
    return rest_.empty();
  }

private:
  // A fill character is recognised by the align sign behind it, so it may be
  // any character, also one of <>^ itself.
  void read_align(Format& format) {
    const auto size = rest_.empty() ? 0 : character_size(rest_[0]);
    if (size < rest_.size() && aligns.find(rest_[size]) != std::string::npos) {
      format.fill = rest_.substr(0, size);
      rest_.remove_prefix(size);
    }
    if (!rest_.empty() && aligns.find(rest_[0]) != std::string_view::npos) {
      format.align = rest_[0];
      rest_.remove_prefix(1);
    }
  }

  bool digits() const {
    return !rest_.empty() && rest_[0] >= '0' && rest_[0] <= '9';
  }

  // Reads digits; 0 if there are none. The value is capped far above all
  // limits, so that it cannot overflow.
  std::size_t number() {
    std::size_t value = 0;
    for (; digits(); rest_.remove_prefix(1))
      value = std::min(value * 10 + static_cast<std::size_t>(rest_[0] - '0'),
                       out_of_bounds);
    return value;
  }

  bool skip(char c) {
    const bool there = rest_.starts_with(c);
    rest_.remove_prefix(there);
    return there;
  }

  std::string_view rest_;
};

std::string quoted(std::string_view text) {
  return "'{:" + std::string(text) + "}'";
}

// What is wrong with a format; empty if nothing is.
std::string wrong(const Format& format, bool understood,
                  std::string_view text) {
  if (!understood || format.decimals == -1)
    return quoted(text) +
           " is no format; write for example {:05} {:>8} {:.2} {:,} {:u}, and "
           "{{ for a brace";
  if (format.width > max_width)
    return quoted(text) + " is wider than " + std::to_string(max_width);
  if (format.decimals.value_or(0) > max_decimals)
    return quoted(text) + " has more than " + std::to_string(max_decimals) +
           " decimals";
  return {};
}

// Splits a pattern into pieces. "{{" and "}}" are braces; a single brace that
// opens no place is text.
class PatternReader {
public:
  explicit PatternReader(std::string_view pattern) : pattern_(pattern) {}

  // The last piece has the text behind the last place.
  FormatPattern read() {
    while (at_ < pattern_.size() && result_.error.empty())
      step();
    result_.pieces.push_back({std::move(text_), {}});
    return std::move(result_);
  }

private:
  void step() {
    const auto two = pattern_.substr(at_, 2);
    if (two == "{}") {
      at_ += 2;
      take({});
    } else if (two == "{:") {
      described();
    } else {
      text_ += pattern_[at_];
      at_ += 1U + (two == "{{" || two == "}}");
    }
  }

  // {:…} with a format; an error names the whole place.
  void described() {
    const auto end = std::min(pattern_.find('}', at_), pattern_.size());
    const auto text = pattern_.substr(at_ + 2, end - at_ - 2);
    Reader reader(text);
    const auto format = reader.read();
    result_.error = wrong(format, reader.done() && end < pattern_.size(), text);
    at_ = end + 1;
    take(format);
  }

  // Ends a piece: the text before, and this place.
  void take(const Format& format) {
    result_.pieces.push_back({std::move(text_), format});
    text_.clear();
    ++result_.places;
  }

  std::string_view pattern_;
  std::size_t at_ = 0;
  std::string text_;
  FormatPattern result_;
};

// A comma before each group of three digits, from the right.
std::string with_commas(std::string whole) {
  for (auto at = whole.size(); at > 3;) {
    at -= 3;
    whole.insert(at, 1, ',');
  }
  return whole;
}

// Applies u, l or c; text that is not valid UTF-8 stays as it is.
std::string in_letters(std::string text, char letters) {
  if (letters == 'u')
    return capitals(text).value_or(text);
  if (letters == 'l')
    return small_letters(text).value_or(text);
  const auto first = text.empty() ? 0 : character_size(text[0]);
  if (letters == 'c')
    return capitals(text.substr(0, first)).value_or("") + text.substr(first);
  return text;
}

std::string repeated(const std::string& character, std::size_t count) {
  std::string text;
  while (count-- > 0)
    text += character;
  return text;
}

} // namespace

FormatPattern parse_format(std::string_view pattern) {
  return PatternReader(pattern).read();
}

// Works on decimal digits, so no digit is lost by binary rounding: 2.675 with
// two decimals is 2.68.
std::string formatted(const Decimal& given, const Format& format) {
  if (!format.needs_number())
    return decimal_text(given);
  // Rounded first: rounding can add a digit before the point.
  const auto number =
      format.decimals ? rounded(given, *format.decimals) : given;
  auto whole = whole_digits(number);
  if (format.thousands)
    whole = with_commas(std::move(whole));
  auto fraction = fraction_digits(number);
  if (format.decimals)
    fraction.resize(static_cast<std::size_t>(*format.decimals), '0');
  if (!fraction.empty())
    fraction.insert(0, 1, '.');
  const std::string sign = number.negative ? "-" : format.sign ? "+" : "";
  const auto size = sign.size() + whole.size() + fraction.size();
  const auto zeros =
      format.zeros && size < format.width ? format.width - size : 0;
  return sign + std::string(zeros, '0') + whole + fraction;
}

// The width counts characters, not bytes.
std::string laid_out(std::string text, const Format& format, bool is_number) {
  text = in_letters(std::move(text), format.letters);
  const auto size = count_code_points(text);
  if (size >= format.width)
    return text;
  const auto room = format.width - size;
  const char align = format.align ? format.align : is_number ? '>' : '<';
  const auto before = align == '>' ? room : align == '^' ? room / 2 : 0;
  return repeated(format.fill, before) + text +
         repeated(format.fill, room - before);
}

} // namespace parlour::script
