// Reads dates relative to today: "tomorrow", "next friday", "in two weeks".
#include "adapters/nlu/forms/calendar.hpp"

namespace parlour::adapters::nlu {

namespace {

using std::chrono::days;
using std::chrono::weekday;

// Days, weeks or months; a larger number is no date.
constexpr std::int64_t max_ahead = 1000;

std::optional<FormAt> as_form(const FormReader& reader,
                              std::optional<Day> day) {
  return day ? std::optional(reader.form(date_text(*day))) : std::nullopt;
}

// A part of the day belongs to the date but does not change it: "tomorrow
// morning".
void skip_part_of_day(FormReader& reader) {
  reader.skip_any({"morning", "afternoon", "evening", "night"});
}

bool skip_this_part_of_day(FormReader& reader) {
  return reader.skip_all({"this", "morning"}) ||
         reader.skip_all({"this", "afternoon"}) ||
         reader.skip_all({"this", "evening"});
}

// Reads "today", "tomorrow night", "yesterday" or "day after tomorrow".
std::optional<Day> near_day(FormReader& reader, Day today) {
  if (reader.skip_all({"day", "after", "tomorrow"}))
    return today + days(2);
  if (reader.skip_all({"day", "before", "yesterday"}))
    return today - days(2);
  if (reader.skip_any({"today", "tonight"}) || skip_this_part_of_day(reader))
    return today;
  if (reader.skip("yesterday"))
    return today - days(1);
  if (!reader.skip_any({"tomorrow", "tmr", "tmrw"}))
    return {};
  skip_part_of_day(reader);
  return today + days(1);
}

// The weekday in the week after the current one. Weeks begin on Monday.
Day in_next_week(Day today, weekday wanted) {
  const auto monday = today + days(8 - weekday(today).iso_encoding());
  return monday + days(wanted.iso_encoding() - 1);
}

// "friday" is the next one after today, "next friday" the one of next week,
// "last friday" the one before today.
std::optional<Day> named_weekday(FormReader& reader, Day today) {
  reader.skip("this");
  reader.skip("coming");
  const bool next = reader.skip_all({"next", "week"}) || reader.skip("next");
  const bool last = !next && reader.skip("last");
  const auto wanted = weekday_of(reader.word());
  if (!wanted)
    return {};
  reader.advance();
  // 0 to 6 days.
  const auto ahead = (*wanted - weekday(today)).count();
  if (last)
    return today - days(ahead == 0 ? 7 : 7 - ahead);
  if (next || reader.skip_all({"next", "week"}))
    return in_next_week(today, *wanted);
  skip_part_of_day(reader);
  return today + days(ahead == 0 ? 7 : ahead);
}

// A day from which others count. A following "week" adds a week: "tuesday
// week".
std::optional<Day> anchor(FormReader& reader, Day today) {
  reader.skip("the");
  auto day = near_day(reader, today);
  if (!day)
    day = named_weekday(reader, today);
  if (day && reader.skip("week"))
    return *day + days(7);
  return day;
}

std::optional<FormAt> anchored(FormReader reader, Day today) {
  const auto day = anchor(reader, today);
  return as_form(reader, day);
}

// Today if it is in a weekend, otherwise the coming Saturday.
Day weekend(Day today) {
  const auto encoded = weekday(today).iso_encoding();
  return encoded >= 6 ? today : today + days(6 - encoded);
}

// Reads "next week", "this weekend" and the like.
std::optional<FormAt> week_or_month(FormReader reader, Day today) {
  if (reader.skip_all({"next", "week"}))
    return as_form(reader, today + days(7));
  if (reader.skip_all({"week", "after", "next"}))
    return as_form(reader, today + days(14));
  if (reader.skip_all({"next", "month"}))
    return as_form(reader, months_later(today, 1));
  if (reader.skip_all({"next", "weekend"}))
    return as_form(reader, in_next_week(today, std::chrono::Saturday));
  reader.skip("this");
  if (reader.skip("weekend"))
    return as_form(reader, weekend(today));
  return {};
}

// Reads "three days", "a couple of weeks" or "a fortnight" and returns the day
// so long after `from`.
std::optional<Day> after(FormReader& reader, Day from) {
  const bool one = reader.word(1) != "couple" && reader.skip_any({"a", "an"});
  const auto number = one ? std::nullopt : reader.count();
  if (!one && (!number || number->ordinal || number->value > max_ahead))
    return {};
  const auto count = one ? 1 : static_cast<int>(number->value);
  if (reader.skip_any({"days", "day"}))
    return from + days(count);
  if (reader.skip_any({"weeks", "week"}))
    return from + days(7 * count);
  if (reader.skip_any({"fortnight", "fortnights"}))
    return from + days(14 * count);
  if (reader.skip_any({"months", "month"}))
    return months_later(from, count);
  return {};
}

// Reads "in two weeks" or "in three days' time".
std::optional<FormAt> ahead(FormReader reader, Day today) {
  if (!reader.skip("in"))
    return {};
  const auto day = after(reader, today);
  if (day)
    reader.skip("time");
  return as_form(reader, day);
}

// "for three days from monday" tells a duration and a start, not a date.
bool tells_how_long(const FormReader& start) {
  return start.word_before() == "for" && start.word() != "a";
}

// Reads "a week on tuesday", "three days from now" or "a week today". The span
// comes before its anchor, so it is read twice: first to get past it, then from
// the anchor.
std::optional<FormAt> ahead_of_anchor(FormReader reader, Day today) {
  const auto start = reader;
  if (!after(reader, today))
    return {};
  bool weak = tells_how_long(start) && reader.word() == "from";
  const bool joined = reader.skip_any({"on", "from", "after"});
  auto from = std::optional(today);
  if (joined && reader.skip("now"))
    weak = false;
  else
    from = anchor(reader, today);
  if (!from)
    return {};
  auto count = start;
  auto form = as_form(reader, after(count, *from));
  if (form)
    form->weak = weak;
  return form;
}

// Reads "of this month", "of the month" or "of next month". Returns how many
// months ahead that is.
std::optional<int> of_month(FormReader& reader) {
  if (reader.skip_all({"of", "next", "month"}))
    return 1;
  if (reader.skip_all({"of", "this", "month"}) ||
      reader.skip_all({"of", "the", "month"}))
    return 0;
  return {};
}

// Reads "3rd of next month" or "end of the month".
std::optional<FormAt> within_month(FormReader reader, Day today) {
  const bool end = reader.skip("end");
  const auto number = end ? std::nullopt : reader.number();
  if (!end && (!number || !number->ordinal))
    return {};
  const auto months = of_month(reader);
  if (!months)
    return {};
  // 27 days before the end of a month is a day that every month has.
  const auto last =
      last_of_month(months_later(last_of_month(today) - days(27), *months));
  if (end)
    return as_form(reader, last);
  const std::chrono::year_month_day date(last);
  return as_form(reader, make_day(int(date.year()), unsigned(date.month()),
                                  number->value));
}

} // namespace

std::optional<FormAt> day_of_month(FormReader& reader, Day today) {
  reader.skip("the");
  const auto number = reader.number();
  if (!number || !number->ordinal || number->value < 1 || number->value > 31)
    return {};
  const std::chrono::year_month_day now(today);
  // One of three months in a row has a 31st.
  auto month = now.year() / now.month();
  for (int tried = 0; tried < 3; ++tried, month += std::chrono::months(1)) {
    const auto day =
        make_day(int(month.year()), unsigned(month.month()), number->value);
    if (day && *day >= today)
      return reader.form(date_text(*day), true);
  }
  return {};
}

std::optional<FormAt> date_from_now(FormReader reader, Day today) {
  auto start = reader;
  start.skip("the");
  // All readers are tried, and the longest reading is taken: "tomorrow week" is
  // more than "tomorrow".
  std::optional<FormAt> best;
  for (const auto read :
       {anchored, week_or_month, ahead, ahead_of_anchor, within_month}) {
    auto found = read(start, today);
    if (found && (!best || found->length > best->length))
      best = std::move(found);
  }
  return best ? best : day_of_month(reader, today);
}

} // namespace parlour::adapters::nlu
