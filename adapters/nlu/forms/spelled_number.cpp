// Reads numbers that are said digit by digit.
#include <string>

#include "adapters/nlu/forms/form_reader.hpp"
#include "adapters/nlu/forms/normal_forms.hpp"

namespace parlour::adapters::nlu {

namespace {

// As many as digits_of() reads.
constexpr std::size_t max_digits = 15;

struct Spelled {
  std::string digits;
  // A digit is doubled, which happens in no ordinary number.
  bool sure = false;
};

// Behind the first digits there may be pairs: "two one oh, thirty six".
Spelled one_by_one(FormReader& reader) {
  Spelled made;
  while (made.digits.size() < max_digits) {
    const auto start = reader.position();
    const auto count = repeats(reader);
    const auto digit = digit_of(reader.word());
    if (!digit) {
      reader.go_back(start);
      const auto pair = made.digits.size() < 2 ? 0 : two_digits(reader);
      if (pair == 0) {
        reader.go_back(start);
        break;
      }
      made.digits += std::to_string(pair);
      continue;
    }
    reader.advance();
    made.digits.append(count, static_cast<char>('0' + *digit));
    made.sure = made.sure || count > 1;
  }
  return made;
}

// "two oh six eight seven, no, eight eight"
Spelled with_repairs(FormReader& reader) {
  auto made = one_by_one(reader);
  repair_digits(reader, made.digits, [&] { return one_by_one(reader).digits; });
  return made;
}

// Whether the number goes on in a way that makes it an ordinary one, whose
// words add up: "five hundred", "forty seven point two".
bool goes_on(FormReader& reader) {
  const auto start = reader.position();
  const bool more = reader.word() == "point" || reader.word() == "and" ||
                    reader.number().has_value() || reader.word() == "hundred" ||
                    reader.word() == "thousand" || reader.word() == "million";
  reader.go_back(start);
  return more;
}

} // namespace

bool skip_repair(FormReader& reader) {
  const bool denies = reader.skip("no");
  const bool excuses = reader.skip("sorry");
  const bool means = reader.skip_all({"i", "mean"}) ||
                     reader.skip_all({"i", "meant"}) || reader.skip("rather");
  return denies || excuses || means;
}

std::size_t repeats(FormReader& reader) {
  if (reader.skip("double"))
    return 2;
  return reader.skip("triple") ? 3 : 1;
}

std::int64_t two_digits(FormReader& reader) {
  const auto number = reader.number();
  const bool fits = number && !number->ordinal && !number->digits &&
                    number->value >= 10 && number->value < 100;
  return fits ? number->value : 0;
}

std::optional<std::int64_t> spelled_number(FormReader& reader) {
  const auto start = reader.position();
  const auto spelled = with_repairs(reader);
  const bool is_all = start == 0 && reader.word().empty();
  // "nine one" alone is spelt; within a sentence at least three digits are
  // needed.
  const std::size_t least = spelled.sure || is_all ? 2 : 3;
  if (spelled.digits.size() >= least && !goes_on(reader))
    return digits_of(spelled.digits);
  reader.go_back(start);
  const auto first = two_digits(reader);
  const auto second = first > 0 ? two_digits(reader) : 0;
  if (second > 0 && !goes_on(reader))
    return first * 100 + second;
  reader.go_back(start);
  return {};
}

} // namespace parlour::adapters::nlu
