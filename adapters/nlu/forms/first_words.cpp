#include "adapters/nlu/forms/first_words.hpp"

#include "adapters/nlu/forms/calendar.hpp"
#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

// Besides number words, digits, months and weekdays.
const WordSet& other_first_words() {
  static const WordSet words{
      // counts
      "a", "an", "half", "quarter", "couple", "pair", "dozen",
      // digits and signs
      "oh", "o", "double", "triple", "plus", "minus", "negative", "point",
      // times
      "noon", "midday", "lunchtime", "midnight", "now", "immediately", "asap",
      "right", "at", "straight", "as", "in",
      // dates
      "the", "day", "today", "tonight", "this", "yesterday", "tomorrow", "tmr",
      "tmrw", "coming", "next", "last", "week", "weekend", "end", "new",
      "christmas", "boxing", "valentine", "valentines",
      // levels
      "basement", "floor", "floors", "level", "storey", "story", "flr", "lower",
      "ground", "street", "main"};
  return words;
}

} // namespace

// Digits: also "+65", "b2" and "l3".
bool may_begin_form(std::string_view word) {
  return has_digit(word) || other_first_words().contains(word) ||
         is_number_word(word) || month_of(word) != 0 ||
         weekday_of(word).has_value();
}

} // namespace parlour::adapters::nlu
