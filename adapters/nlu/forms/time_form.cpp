// Reads times of the day: "10:30am", "half past ten", "three thirty in the
// afternoon", "noon", "in ten minutes".
#include <charconv>

#include "adapters/nlu/forms/form_reader.hpp"
#include "adapters/nlu/forms/half_of_day.hpp"
#include "adapters/nlu/forms/normal_forms.hpp"
#include "runtime/text/shifted_time.hpp"

namespace parlour::adapters::nlu {

namespace {

// A time before the half of the day is known.
struct Time {
  std::int64_t hour = 0;
  std::int64_t minute = 0;
  // Written with a leading zero or as 24 hours: the half of the day is not
  // guessed.
  bool exact = false;
  bool weak = true;
};

// Hours before this one are taken for the afternoon if the half is not said.
constexpr std::int64_t first_office_hour = 8;

// The hour of 24. If the time says no half of the day, its sentence may: that
// decides for an hour that may be either, but noon stays noon.
std::int64_t hour_of(const Time& time, Half half, const FormReader& reader) {
  if (half != Half::unknown)
    return hour_in_half(time.hour, half);
  const auto beside = half_of_sentence(reader);
  const bool either = time.hour > 0 && time.hour < 12;
  if ((beside != Half::unknown && either) ||
      (beside == Half::night && time.hour == 12))
    return hour_in_half(time.hour, beside);
  // "3" is 15, but "03" and "15" are meant as they stand.
  const bool guess =
      !time.exact && time.hour > 0 && time.hour < first_office_hour;
  return guess ? time.hour + 12 : time.hour;
}

// Reads what may follow a time and makes the form. A bare hour is weak: "four"
// may be a number as well.
std::optional<FormAt> finish(FormReader& reader, Time time) {
  if (reader.skip("oclock") || reader.skip_all({"o", "clock"}))
    time.weak = false;
  reader.skip("ish");
  const auto half = skip_half(reader);
  const bool sharp = reader.skip("sharp");
  time.weak = time.weak && half == Half::unknown && !sharp;
  if (time.hour > 24 || time.minute > 59 || time.minute < 0)
    return {};
  const auto hour = hour_of(time, half, reader);
  return reader.form(clock_text(hour * 60 + time.minute), time.weak);
}

// Whether three digits are likelier a time than a room: "430".
bool is_quarter(std::int64_t digits) {
  const auto minute = digits % 100;
  return digits / 100 > 0 && (minute == 15 || minute == 30 || minute == 45);
}

// Splits "10:30", "10.30", "1030", "430" or "10" into hour and minute. What
// follows the digits is left in `rest`. With a point the time stays weak, since
// it may be a decimal number.
std::optional<Time> split_digits(std::string_view word,
                                 std::string_view& rest) {
  const auto end = word.find_first_not_of("0123456789");
  const auto first = word.substr(0, end);
  const auto hour = digits_of(first);
  if (!hour)
    return {};
  rest = end == std::string_view::npos ? "" : word.substr(end);
  Time time{*hour, 0, first.size() == 2 && first[0] == '0', true};
  // "10:30" or "10.30": exactly two digits of minutes.
  if (rest.size() >= 3 && (rest[0] == ':' || rest[0] == '.')) {
    const auto minute = digits_of(rest.substr(1, 2));
    if (!minute)
      return {};
    time.minute = *minute;
    time.weak = rest[0] == '.';
    rest.remove_prefix(3);
    if (!rest.empty() && rest[0] >= '0' && rest[0] <= '9')
      return {};
    // "1030", or "930" before "am".
  } else if (first.size() == 4 ||
             (first.size() == 3 && (!rest.empty() || is_quarter(*hour)))) {
    time = {*hour / 100, *hour % 100, first[0] == '0', true};
  } else if (first.size() > 2) {
    return {};
  }
  return time;
}

// Reads the minutes of "10 30", as speech recognisers write it.
void add_written_minutes(FormReader& reader, Time& time) {
  const auto word = reader.word();
  const auto minute = digits_of(word);
  if (word.size() != 2 || !minute || *minute > 59)
    return;
  time.minute = *minute;
  reader.advance();
}

// Reads "10:30am", "3pm", "1530 hours" or "10.30".
std::optional<FormAt> digital_time(FormReader reader) {
  std::string_view rest;
  const auto word = reader.word();
  auto time = split_digits(word, rest);
  if (!time || time->hour > 24)
    return {};
  reader.advance();
  if (rest == "am" || rest == "pm") {
    const auto hour =
        hour_in_half(time->hour, rest == "am" ? Half::am : Half::pm);
    if (time->minute > 59)
      return {};
    reader.skip("sharp");
    return reader.form(clock_text(hour * 60 + time->minute));
  }
  if (rest == "h" || rest == "hrs" || reader.skip_any({"hours", "hrs"}))
    *time = {time->hour, time->minute, true,
             word.size() < 3 && time->hour < 13 && time->minute == 0};
  else if (!rest.empty())
    return {};
  else if (word.size() <= 2)
    add_written_minutes(reader, *time);
  return finish(reader, *time);
}

// Reads the minutes after an hour: "thirty", "oh five", "15".
std::optional<std::int64_t> minutes(FormReader& reader) {
  const auto start = reader.position();
  if (reader.skip_any({"oh", "o", "zero"})) {
    const auto digit = digit_of(reader.word());
    if (digit) {
      reader.advance();
      return *digit;
    }
  } else if (const auto number = reader.number(); number && !number->ordinal &&
                                                  number->value >= 10 &&
                                                  number->value <= 59) {
    return number->value;
  }
  reader.go_back(start);
  return {};
}

// Reads "sixteen hundred hours" or "oh eight hundred hours".
std::optional<FormAt> hundred_hours(FormReader reader) {
  reader.skip_any({"oh", "o", "zero"});
  const auto number = reader.number();
  if (!number || number->ordinal || number->digits ||
      number->value % 100 != 0 || number->value < 100 || number->value > 2400)
    return {};
  const bool whole = reader.skip("hours");
  return reader.form(clock_text(number->value / 100 * 60), !whole);
}

bool is_tens(std::string_view word) {
  return word == "twenty" || word == "thirty" || word == "forty" ||
         word == "fifty";
}

// Reads "three", "ten thirty", "nine oh five" or "three o'clock".
std::optional<FormAt> spoken_time(FormReader reader) {
  // "twenty-five o'clock" is no time: its second word is none either.
  if (is_tens(reader.word_before()) && digit_of(reader.word()))
    return {};
  const auto hour = reader.number();
  if (!hour || hour->ordinal || hour->digits || hour->value > 24)
    return {};
  Time time{hour->value, 0, hour->value == 0, true};
  if (const auto minute = minutes(reader)) {
    time.minute = *minute;
    time.weak = false;
  }
  return finish(reader, time);
}

// Reads "noon" or "midnight".
std::optional<std::int64_t> hour_by_name(FormReader& reader) {
  if (reader.skip_any({"noon", "midday", "lunchtime"}))
    return 12;
  if (reader.skip("midnight"))
    return 0;
  return {};
}

// Reads the minutes before "past" and "to": "half", "a quarter", "ten minutes".
std::optional<std::int64_t> fraction(FormReader& reader) {
  if (reader.skip("half"))
    return 30;
  const auto start = reader.position();
  reader.skip("a");
  if (reader.skip("quarter"))
    return 15;
  const auto number = reader.number();
  if (number && !number->ordinal && number->value > 0 && number->value < 60) {
    reader.skip_any({"minutes", "minute"});
    return number->value;
  }
  reader.go_back(start);
  return {};
}

// Whether the minutes, whose first word was `first`, come after the hour that
// follows. Nothing if neither is said. "half ten" is half past ten.
std::optional<bool> is_past(FormReader& reader, std::string_view first) {
  if (reader.skip_any({"past", "after"}))
    return true;
  if (reader.skip_any({"to", "before", "till", "til"}))
    return false;
  if (first == "half")
    return true;
  if (first == "quarter" && reader.skip("of"))
    return false;
  return {};
}

// "half past", "quarter to" of an hour that was said before: the dialogue knows
// it.
std::optional<FormAt> without_hour(const FormReader& reader, std::int64_t count,
                                   bool past) {
  return reader.form((past ? "past " : "to ") + clock_text(count), true);
}

// Reads "half past ten", "a quarter to three", "ten minutes past nine" or "half
// past noon".
std::optional<FormAt> relative_time(FormReader reader) {
  const auto first = reader.word() == "a" ? reader.word(1) : reader.word();
  const auto count = fraction(reader);
  const auto minutes_end = reader.position();
  const auto after = count ? is_past(reader, first) : std::nullopt;
  if (!after)
    return {};
  const bool past = *after;
  if (reader.position() > minutes_end && reader.ends_clause() &&
      (first == "half" || first == "quarter"))
    return without_hour(reader, *count, past);
  if (const auto named = hour_by_name(reader))
    return reader.form(clock_text(*named * 60 + (past ? *count : -*count)));
  const auto hour = reader.number();
  if (!hour || hour->ordinal || hour->value < 1 || hour->value > 12)
    return {};
  reader.skip("oclock");
  const auto half = skip_half(reader);
  const auto start = hour_of({hour->value, 0, false, false}, half, reader) * 60;
  // The half of the day is that of the hour which is named: a quarter to eight
  // is in the morning, as eight is.
  return reader.form(clock_text(past ? start + *count : start - *count));
}

// Reads "noon", "twelve noon", "midnight" …
std::optional<FormAt> named_time(FormReader reader) {
  reader.skip_any({"12", "twelve"});
  const auto hour = hour_by_name(reader);
  if (!hour)
    return {};
  reader.skip("sharp");
  return reader.form(clock_text(*hour * 60));
}

// In local time.
std::int64_t minute_of_day(Timestamp now) {
  const auto text = format_timestamp(now, "%H%M");
  const auto number = digits_of(text).value_or(0);
  return number / 100 * 60 + number % 100;
}

// Reads expressions that mean now.
bool skip_at_once(FormReader& reader) {
  return reader.skip_any({"immediately", "asap"}) ||
         reader.skip_all({"right", "now"}) || reader.skip_all({"at", "once"}) ||
         reader.skip_all({"right", "away"}) ||
         reader.skip_all({"straight", "away"}) ||
         reader.skip_all({"as", "soon", "as", "possible"});
}

// Reads "now", "right away", "in ten minutes" or "half an hour from now".
std::optional<FormAt> time_from_now(FormReader reader, Now now) {
  if (!now)
    return {};
  const auto current = minute_of_day(*now);
  if (reader.skip("now") || skip_at_once(reader))
    return reader.form(clock_text(current), true);
  const bool in = reader.skip("in");
  const auto span = duration_form(reader, now);
  if (!span)
    return {};
  reader.advance(span->length - reader.length());
  if (in)
    reader.skip("time");
  else if (!reader.skip_all({"from", "now"}))
    return {};
  const auto seconds = span->value.integer_or(0);
  // Beyond a day the date would change.
  if (seconds >= 86'400)
    return {};
  return reader.form(clock_text(current + seconds / 60));
}

// Reads "an hour later" or "half an hour earlier": a difference with its sign,
// which the dialogue adds to the time that it knows.
std::optional<FormAt> shifted_time(FormReader reader, Now now) {
  const auto span = duration_form(reader, now);
  if (!span)
    return {};
  reader.advance(span->length - reader.length());
  const bool later = reader.skip("later");
  if (!later && !reader.skip_any({"earlier", "sooner"}))
    return {};
  const auto minutes = span->value.integer_or(0) / 60;
  if (minutes < 1 || minutes >= 1440)
    return {};
  return reader.form((later ? "+" : "-") + clock_text(minutes));
}

} // namespace

std::optional<FormAt> time_form(FormReader reader, Now now) {
  std::optional<FormAt> best;
  // All readers are tried, and the longest reading is taken.
  const auto keep = [&](std::optional<FormAt> found) {
    if (found && (!best || found->length > best->length))
      best = std::move(found);
  };
  keep(digital_time(reader));
  keep(spoken_time(reader));
  keep(hundred_hours(reader));
  keep(relative_time(reader));
  keep(named_time(reader));
  keep(time_from_now(reader, now));
  keep(shifted_time(reader, now));
  return best;
}

} // namespace parlour::adapters::nlu
