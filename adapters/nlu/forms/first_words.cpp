#include "adapters/nlu/forms/first_words.hpp"

#include "adapters/nlu/forms/calendar.hpp"
#include "adapters/nlu/forms/number_words.hpp"
#include "adapters/nlu/text/has.hpp"
#include "adapters/nlu/text/word_set.hpp"

namespace parlour::adapters::nlu {

namespace {

// Besides digits, number words, months and weekdays.

const WordSet& words_of_numbers() {
  static const WordSet words{"a",      "an",    "half",  "quarter",  "couple",
                             "pair",   "dozen", "oh",    "o",        "double",
                             "triple", "plus",  "minus", "negative", "point"};
  return words;
}

const WordSet& words_of_times() {
  static const WordSet words{"noon", "midday",      "lunchtime", "midnight",
                             "now",  "immediately", "asap",      "right",
                             "at",   "straight",    "as",        "in"};
  return words;
}

const WordSet& words_of_dates() {
  static const WordSet words{
      "the",      "day",       "today",     "tonight", "this",      "yesterday",
      "tomorrow", "tmr",       "tmrw",      "coming",  "next",      "last",
      "week",     "end",       "weekend",   "new",     "christmas", "boxing",
      "in",       "valentine", "valentines"};
  return words;
}

const WordSet& words_of_levels() {
  static const WordSet words{"basement", "floor",  "floors", "level",
                             "storey",   "story",  "flr",    "lower",
                             "ground",   "street", "main"};
  return words;
}

bool may_begin_any(std::string_view word) {
  return has_digit(word) || is_number_word(word) ||
         words_of_numbers().contains(word);
}

} // namespace

// Digits: also "+65", "b2" and "l3".
Forms forms_from(std::string_view word) {
  if (may_begin_any(word))
    return static_cast<Forms>((1U << form_count) - 1);
  unsigned forms = forms_bit(Form::email);
  if (words_of_times().contains(word))
    forms |= forms_bit(Form::time);
  if (words_of_dates().contains(word) || month_of(word) != 0 ||
      weekday_of(word))
    forms |= forms_bit(Form::date);
  if (words_of_levels().contains(word))
    forms |= forms_bit(Form::level);
  return static_cast<Forms>(forms);
}

} // namespace parlour::adapters::nlu
