// Days, months and weekdays for the dates that people say.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "adapters/nlu/forms/form_reader.hpp"

namespace parlour::adapters::nlu {

using Day = std::chrono::sys_days;

// "2026-11-21".
std::string date_text(Day day);

// Nothing for days that are none: 31 February, years outside of 1900 to 2200.
std::optional<Day> make_day(std::int64_t year, std::int64_t month,
                            std::int64_t day);

// "2026-11-21", "21/11/2026", "21.11.26"; where it must be, the month first. A
// year of two digits lies from 79 years ago to 20 years ahead.
std::optional<Day> read_day(std::string_view text, char separator, Now now);

std::optional<Day> day_of(Now now);

// The same day so many months later, or the month's last.
Day months_later(Day day, int count);

Day last_of_month(Day day);

// 1 to 12, 0 for none; short names of three letters and more count.
std::int64_t month_of(std::string_view word);

std::optional<std::chrono::weekday> weekday_of(std::string_view word);

// What is said of a day that is not today: "tomorrow", "next tuesday week",
// "in two weeks", "the 3rd of next month".
std::optional<FormAt> date_from_now(FormReader reader, Day today);

// "the 21st": this month or one of the next two.
std::optional<FormAt> day_of_month(FormReader& reader, Day today);

} // namespace parlour::adapters::nlu
