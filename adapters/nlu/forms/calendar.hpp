// Arithmetic with days, months and weekdays for the dates that people say.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "adapters/nlu/forms/form_reader.hpp"

namespace parlour::adapters::nlu {

using Day = std::chrono::sys_days;

// "2026-11-21", the normal form of a date.
std::string date_text(Day day);

// Nothing if there is no such day (31 February) or the year is not in 1900 to
// 2200.
std::optional<Day> make_day(std::int64_t year, std::int64_t month,
                            std::int64_t day);

// Reads "2026-11-21", "21/11/2026", "21.11.26". The day comes before the month,
// unless the second number can only be a day. A year of two digits lies from 79
// years ago to 20 years ahead.
std::optional<Day> read_day(std::string_view text, char separator, Now now);

// The day of the clock, or nothing if there is none.
std::optional<Day> day_of(Now now);

// The same day `count` months later, or the last day of that month.
Day months_later(Day day, int count);

Day last_of_month(Day day);

// 1 to 12, or 0. Abbreviations of three letters and more count.
std::int64_t month_of(std::string_view word);

std::optional<std::chrono::weekday> weekday_of(std::string_view word);

// Reads a date relative to `today`: "tomorrow", "next tuesday week", "in two
// weeks", "the 3rd of next month".
std::optional<FormAt> date_from_now(FormReader reader, Day today);

// Reads "the 21st": the next day of that number, within this and the next two
// months.
std::optional<FormAt> day_of_month(FormReader& reader, Day today);

} // namespace parlour::adapters::nlu
