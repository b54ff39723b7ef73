// Reads telephone numbers and e-mail addresses, written or spelt out.
#include "adapters/nlu/forms/form_reader.hpp"
#include "adapters/nlu/forms/normal_forms.hpp"

namespace parlour::adapters::nlu {

namespace {

constexpr std::size_t fewest_digits = 3;
// A number with fewer digits is only a telephone number where one is expected.
constexpr std::size_t whole_number = 7;
// The longest international number (E.164).
constexpr std::size_t max_digits = 15;

// The digits of "9123-4567", "+65" or "91234567"; empty if the word is no such
// number.
std::string written_digits(std::string_view word) {
  std::string digits;
  for (const char letter : word) {
    const bool counts =
        (letter >= '0' && letter <= '9') || (letter == '+' && digits.empty());
    if (counts)
      digits += letter;
    else if (letter != '-')
      return {};
  }
  return digits;
}

// Reads "double five", "nine", "ninety one" or "9123"; empty if no digit
// follows.
std::string next_digits(FormReader& reader) {
  const auto start = reader.position();
  if (reader.skip("plus"))
    return "+";
  const auto count = repeats(reader);
  if (const auto digit = digit_of(reader.word())) {
    reader.advance();
    return std::string(count, static_cast<char>('0' + *digit));
  }
  if (auto digits = written_digits(reader.word());
      !digits.empty() && count == 1) {
    reader.advance();
    return digits;
  }
  reader.go_back(start);
  if (const auto pair = two_digits(reader); pair != 0)
    return std::to_string(pair);
  reader.go_back(start);
  return {};
}

std::size_t count_of(std::string_view number) {
  return number.size() - (number.starts_with('+') ? 1 : 0);
}

// Appends digits as long as the number may grow; a "+" only at its beginning.
std::string all_digits(FormReader& reader) {
  std::string number;
  while (true) {
    const auto start = reader.position();
    const auto digits = next_digits(reader);
    if (digits.empty() || count_of(number + digits) > max_digits ||
        (digits[0] == '+' && !number.empty())) {
      reader.go_back(start);
      return number;
    }
    number += digits;
  }
}

// Reads "comptec dot com"; empty if a dot is needed and missing.
std::string dotted(FormReader& reader, bool need_dot) {
  std::string text(reader.word());
  if (text.empty())
    return {};
  reader.advance();
  bool dots = false;
  while (reader.word() == "dot" && !reader.word(1).empty()) {
    reader.advance();
    text += '.' + std::string(reader.word());
    reader.advance();
    dots = true;
  }
  return dots || !need_dot ? text : std::string();
}

} // namespace

std::optional<FormAt> phone_form(FormReader reader, Now) {
  auto number = all_digits(reader);
  repair_digits(reader, number, [&] { return all_digits(reader); });
  const auto count = count_of(number);
  if (number.empty() || count < fewest_digits || count > max_digits)
    return {};
  return reader.form(number, count < whole_number);
}

std::optional<FormAt> email_form(FormReader reader, Now) {
  const auto word = reader.word();
  // The tokenizer has checked the form of a written address.
  if (word.find('@') != std::string_view::npos) {
    reader.advance();
    return reader.form(std::string(word));
  }
  auto name = dotted(reader, false);
  if (name.empty() || !reader.skip("at"))
    return {};
  const auto host = dotted(reader, true);
  if (host.empty())
    return {};
  return reader.form(name + '@' + host);
}

} // namespace parlour::adapters::nlu
