#include <gtest/gtest.h>

#include "adapters/nlu/normal_forms.hpp"

namespace parlour::adapters::nlu {
namespace {

struct Sample {
  Form form;
  const char* text;
  const char* expected; // "" for none, "~" before what is weak
};

std::string read(const Sample& sample) {
  const auto tokens = tokenize(sample.text);
  const auto now = *parse_timestamp("2026-11-21 09:00"); // a Saturday
  const auto found = form_at(sample.form, tokens, 0, now);
  if (!found || found->length != tokens.list.size())
    return found ? "only a part" : "";
  return (found->weak ? "~" : "") + found->value.text();
}

class Forms : public testing::TestWithParam<Sample> {};

TEST_P(Forms, AreRead) {
  EXPECT_EQ(read(GetParam()), GetParam().expected) << GetParam().text;
}

constexpr auto time = Form::time;
INSTANTIATE_TEST_SUITE_P(
    Time, Forms,
    testing::Values(
        Sample{time, "10:30am", "10:30"}, Sample{time, "10:30 a.m.", "10:30"},
        Sample{time, "10.30", "~10:30"}, Sample{time, "10:30", "10:30"},
        Sample{time, "3:15", "15:15"}, Sample{time, "03:15", "03:15"},
        Sample{time, "3pm", "15:00"}, Sample{time, "12am", "00:00"},
        Sample{time, "12 pm", "12:00"}, Sample{time, "1530 hours", "15:30"},
        Sample{time, "half past ten", "10:30"},
        Sample{time, "half past two", "14:30"},
        Sample{time, "quarter to three", "14:45"},
        Sample{time, "a quarter past nine", "09:15"},
        Sample{time, "ten minutes to twelve", "11:50"},
        Sample{time, "half past noon", "12:30"},
        Sample{time, "quarter to midnight", "23:45"},
        Sample{time, "right away", "~09:00"},
        Sample{time, "as soon as possible", "~09:00"},
        Sample{time, "twenty past four", "16:20"},
        Sample{time, "three o'clock", "15:00"}, Sample{time, "three", "~15:00"},
        Sample{time, "nine", "~09:00"}, Sample{time, "ten thirty", "10:30"},
        Sample{time, "nine oh five", "09:05"},
        Sample{time, "seven in the evening", "19:00"},
        Sample{time, "seven in the morning", "07:00"},
        Sample{time, "nine at night", "21:00"}, Sample{time, "noon", "12:00"},
        Sample{time, "twelve noon", "12:00"}, Sample{time, "midnight", "00:00"},
        Sample{time, "now", "~09:00"}, Sample{time, "in ten minutes", "09:10"},
        Sample{time, "in half an hour", "09:30"}, Sample{time, "25:00", ""},
        Sample{time, "10:75", ""}, Sample{time, "banana", ""}));

constexpr auto date = Form::date;
INSTANTIATE_TEST_SUITE_P(
    Date, Forms,
    testing::Values(Sample{date, "today", "2026-11-21"},
                    Sample{date, "tomorrow", "2026-11-22"},
                    Sample{date, "the day after tomorrow", "2026-11-23"},
                    Sample{date, "monday", "2026-11-23"},
                    Sample{date, "next monday", "2026-11-23"},
                    Sample{date, "saturday", "2026-11-28"},
                    Sample{date, "21 november", "2026-11-21"},
                    Sample{date, "the 3rd of may", "2027-05-03"},
                    Sample{date, "november twenty third", "2026-11-23"},
                    Sample{date, "3 May 2028", "2028-05-03"},
                    Sample{date, "2026-12-01", "2026-12-01"},
                    Sample{date, "24/12/2026", "2026-12-24"},
                    Sample{date, "24/12", "2026-12-24"},
                    Sample{date, "in three days", "2026-11-24"},
                    Sample{date, "in two weeks", "2026-12-05"},
                    Sample{date, "the 5th", "~2026-12-05"},
                    Sample{date, "31 february", ""}, Sample{date, "may", ""}));

constexpr auto level = Form::level;
INSTANTIATE_TEST_SUITE_P(
    Level, Forms,
    testing::Values(
        Sample{level, "twenty third floor", "23"},
        Sample{level, "second floor", "2"}, Sample{level, "23rd floor", "23"},
        Sample{level, "level 3", "3"}, Sample{level, "level three", "3"},
        Sample{level, "floor twenty one", "21"},
        Sample{level, "ground floor", "1"}, Sample{level, "basement one", "-1"},
        Sample{level, "basement", "-1"}, Sample{level, "second basement", "-2"},
        Sample{level, "B1", "-1"}, Sample{level, "level B2", "-2"},
        Sample{level, "L5", "5"}, Sample{level, "the moon", ""},
        Sample{level, "five", "~5"}));

INSTANTIATE_TEST_SUITE_P(
    Others, Forms,
    testing::Values(
        Sample{Form::number, "twenty three", "~23"},
        Sample{Form::number, "two hundred and five", "~205"},
        Sample{Form::number, "1,000", "~1000"},
        Sample{Form::number, "2.5", "~2.5"},
        Sample{Form::number, "two point five", "~2.5"},
        Sample{Form::duration, "ten minutes", "600"},
        Sample{Form::duration, "half an hour", "1800"},
        Sample{Form::duration, "an hour and a half", "5400"},
        Sample{Form::duration, "one and a half hours", "5400"},
        Sample{Form::duration, "two hours and thirty minutes", "9000"},
        Sample{Form::phone, "9123 4567", "91234567"},
        Sample{Form::phone, "+65 9123-4567", "+6591234567"},
        Sample{Form::phone, "nine one two three four five six seven",
               "91234567"},
        Sample{Form::phone, "double nine five oh one two three", "9950123"},
        Sample{Form::phone, "995", "~995"}, Sample{Form::phone, "99", ""},
        Sample{Form::email, "David.Lee@comptec.com", "david.lee@comptec.com"},
        Sample{Form::email, "david at comptec dot com", "david@comptec.com"},
        Sample{Form::email, "see you at ten", ""}));

TEST(Forms, NeedANowForWhatIsRelative) {
  EXPECT_FALSE(form_at(Form::date, tokenize("tomorrow"), 0, {}));
  EXPECT_TRUE(form_at(Form::date, tokenize("2026-11-21"), 0, {}));
}

TEST(Forms, AreNamed) {
  EXPECT_EQ(form_of("level"), Form::level);
  EXPECT_EQ(name_of(Form::phone), "phone");
  EXPECT_FALSE(form_of("colour"));
}

} // namespace
} // namespace parlour::adapters::nlu
