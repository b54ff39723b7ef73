// Numbers that are told digit by digit.
#include <string>

#include "adapters/nlu/forms/form_reader.hpp"
#include "adapters/nlu/forms/normal_forms.hpp"

namespace parlour::adapters::nlu {

namespace {

// More is no number that anybody would tell.
constexpr std::size_t most_digits = 15;

struct Spelled {
  std::string digits;
  bool sure = false; // one of them is doubled: it can be nothing else
};

Spelled one_by_one(FormReader& reader) {
  Spelled made;
  while (made.digits.size() < most_digits) {
    const auto start = reader.position();
    const auto count = repeats(reader);
    const auto digit = digit_of(reader.word());
    if (!digit) {
      reader.go_back(start);
      break;
    }
    reader.advance();
    made.digits.append(count, static_cast<char>('0' + *digit));
    made.sure = made.sure || count > 1;
  }
  return made;
}

// "forty seven", in words; 0 for none.
std::int64_t two_digits(FormReader& reader) {
  const auto number = reader.number();
  const bool fits = number && !number->ordinal && !number->digits &&
                    number->value >= 10 && number->value < 100;
  return fits ? number->value : 0;
}

// Whether the number goes on in another way: then it is a sum.
bool goes_on(FormReader& reader) {
  const auto start = reader.position();
  const bool more = reader.word() == "point" || reader.word() == "and" ||
                    reader.number().has_value() || reader.word() == "hundred" ||
                    reader.word() == "thousand" || reader.word() == "million";
  reader.go_back(start);
  return more;
}

} // namespace

std::size_t repeats(FormReader& reader) {
  if (reader.skip("double"))
    return 2;
  return reader.skip("triple") ? 3 : 1;
}

std::optional<std::int64_t> spelled_number(FormReader& reader) {
  const auto start = reader.position();
  const auto spelled = one_by_one(reader);
  const bool is_all = start == 0 && reader.word().empty();
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
