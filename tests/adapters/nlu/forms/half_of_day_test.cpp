#include <string>

#include <gtest/gtest.h>

#include "adapters/nlu/forms/half_of_day.hpp"

namespace parlour::adapters::nlu {
namespace {

// The first time of the text that begins at the word `from`.
std::string time_in(const std::string& text, const std::string& from) {
  const auto tokens = tokenize(text);
  for (std::size_t at = 0; at < tokens.list.size(); ++at)
    if (tokens.list[at].word == from) {
      const auto found = form_at(Form::time, tokens, at, {});
      return found ? found->value.text() : "";
    }
  return "?";
}

TEST(HalfOfDay, IsSaidAnywhereInTheSentence) {
  EXPECT_EQ(time_in("tonight at eight", "eight"), "20:00");
  EXPECT_EQ(time_in("tomorrow morning at half seven", "half"), "07:30");
  EXPECT_EQ(time_in("at half seven tomorrow morning", "half"), "07:30");
  EXPECT_EQ(time_in("in the evening at a quarter to nine", "a"), "20:45");
  EXPECT_EQ(time_in("on friday afternoon at 2:30", "2:30"), "14:30");
  EXPECT_EQ(time_in("at a quarter to twelve, it is tonight", "a"), "23:45");
  EXPECT_EQ(time_in("tomorrow morning at twelve", "twelve"), "12:00");
}

TEST(HalfOfDay, OfAnotherTimeOrSentenceOrOfAGreetingSaysNothing) {
  EXPECT_EQ(time_in("from nine in the morning to five", "five"), "17:00");
  EXPECT_EQ(time_in("good evening, I am here at nine", "nine"), "09:00");
  EXPECT_EQ(time_in("I leave tonight. Call me at nine", "nine"), "09:00");
  EXPECT_EQ(time_in("this evening or in the morning at nine", "nine"), "09:00");
}

TEST(HalfOfDay, OfTheTimeItselfGoesFirst) {
  EXPECT_EQ(time_in("tonight, no, at nine am", "nine"), "09:00");
}

TEST(HalfOfDay, HoursOfTwelveBecomeHoursOfTwentyFour) {
  EXPECT_EQ(hour_in_half(12, Half::am), 0);
  EXPECT_EQ(hour_in_half(12, Half::pm), 12);
  EXPECT_EQ(hour_in_half(6, Half::night), 18);
  EXPECT_EQ(hour_in_half(2, Half::night), 2);
  EXPECT_EQ(hour_in_half(15, Half::am), 15);
}

} // namespace
} // namespace parlour::adapters::nlu
