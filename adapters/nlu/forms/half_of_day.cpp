#include "adapters/nlu/forms/half_of_day.hpp"

#include <algorithm>
#include <array>

namespace parlour::adapters::nlu {

namespace {

// Which half a word means by itself.
Half half_named(std::string_view word) {
  if (word == "morning")
    return Half::am;
  if (word == "afternoon" || word == "evening")
    return Half::pm;
  return word == "tonight" ? Half::night : Half::unknown;
}

// Words of a greeting: "good morning", "a lovely evening".
bool greets(std::string_view before) {
  constexpr std::array<std::string_view, 5> words{"good", "lovely", "nice",
                                                  "beautiful", "every"};
  return std::ranges::find(words, before) != words.end();
}

bool may_end_time(std::string_view word) {
  return is_number_word(word) || digits_of(word) || word == "oclock" ||
         word == "clock";
}

// The word that stands before the whole expression: before "in the morning",
// "this evening" or "tonight".
std::string_view word_before(const Tokens& tokens, std::size_t place) {
  const auto word = [&](std::size_t back) {
    return back <= place ? std::string_view(tokens.list[place - back].word)
                         : std::string_view();
  };
  if (word(1) == "the" && word(2) == "in")
    return word(3);
  return word(1) == "this" || word(1) == "in" ? word(2) : word(1);
}

} // namespace

Half skip_half(FormReader& reader) {
  if (reader.skip("am") || reader.skip_all({"a", "m"}))
    return Half::am;
  if (reader.skip("pm") || reader.skip_all({"p", "m"}))
    return Half::pm;
  const auto start = reader.position();
  if (reader.skip_all({"in", "the"}) || reader.skip_any({"in", "this"})) {
    if (reader.skip("morning"))
      return Half::am;
    if (reader.skip_any({"afternoon", "evening"}))
      return Half::pm;
  } else if (reader.skip_all({"at", "night"}) || reader.skip("tonight")) {
    return Half::night;
  }
  reader.go_back(start);
  return Half::unknown;
}

Half half_of_sentence(const FormReader& reader) {
  const auto& tokens = reader.tokens();
  const auto first = static_cast<std::uint32_t>(reader.begin());
  const auto sentence = stretch_of(tokens, {first, first + 1}, Break::sentence);
  auto found = Half::unknown;
  for (auto place = sentence.begin; place < sentence.end; ++place) {
    const auto half = half_named(tokens.list[place].word);
    if (half == Half::unknown)
      continue;
    const auto before = word_before(tokens, place);
    if (greets(before))
      continue;
    if (may_end_time(before) || (found != Half::unknown && found != half))
      return Half::unknown;
    found = half;
  }
  return found;
}

std::int64_t hour_in_half(std::int64_t hour, Half half) {
  if (hour > 12)
    return hour;
  if (half == Half::pm || (half == Half::night && hour >= 6 && hour < 12))
    return hour % 12 + 12;
  return hour % 12;
}

} // namespace parlour::adapters::nlu
