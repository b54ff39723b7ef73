#include <gmock/gmock.h>

#include "adapters/asr/moonshine_text.hpp"

namespace parlour::adapters::moonshine {
namespace {

TEST(MoonshineText, WritesSpeltNumbersAsFigures) {
  EXPECT_EQ(typed_text("My number is nine, one, two, three, four, five, six, "
                       "seven."),
            "My number is 91234567.");
  EXPECT_EQ(typed_text("9, 1, 2, 3, 4, 5, 6, 7"), "91234567");
  EXPECT_EQ(typed_text("Nine-eight, seven-six-five, oh."), "987650.");
  EXPECT_EQ(typed_text("9123-4567, please"), "91234567, please");
  EXPECT_EQ(typed_text("9123 4567"), "91234567");
}

TEST(MoonshineText, LeavesOtherNumbers) {
  for (const auto* const text :
       {"One, two.", "At 10:30.", "On the one hand", "10 30", "Level 2, 3 cups",
        "nine", "", "-", "one-way"})
    EXPECT_EQ(typed_text(text), text);
}

TEST(MoonshineText, ASentenceEndsANumber) {
  EXPECT_EQ(typed_text("one two three. four five six"), "123. 456");
}

TEST(MoonshineText, WritesTimesAsTyped) {
  EXPECT_EQ(typed_text("at 10.30 a.m. with Dr. Jeffery Ho."),
            "at 10:30 am with Dr. Jeffery Ho.");
  EXPECT_EQ(typed_text("At 5 p.m."), "At 5 pm.");
  EXPECT_EQ(typed_text("At 5 P.M.?"), "At 5 PM.?");
  EXPECT_EQ(typed_text("1.75 litres"), "1.75 litres");
}

TEST(MoonshineText, WritesDaysAsTyped) {
  EXPECT_EQ(typed_text("Is it open to-day, to-night? To-morrow."),
            "Is it open today, tonight? Tomorrow.");
  EXPECT_EQ(typed_text("Good-by, "), "Goodbye,");
}

TEST(MoonshineText, WritesNamesAsTheApplicationDoes) {
  const auto written = [](const std::string& word) -> std::string {
    return word == "sentosa" ? "Sentosa" : word == "am" ? "a.m." : word;
  };
  EXPECT_EQ(with_capitals("a taxi to sentosa, at 5 am.", written),
            "a taxi to Sentosa, at 5 am.");
  EXPECT_EQ(with_capitals("SENTOSA", written), "SENTOSA");
  EXPECT_EQ(with_capitals("", written), "");
}

TEST(MoonshineText, JoinsInitials) {
  EXPECT_EQ(typed_text("Someone from H. R., please."),
            "Someone from HR, please.");
  EXPECT_EQ(typed_text("Where is the A. T. M.? I am lost."),
            "Where is the ATM? I am lost.");
  EXPECT_EQ(typed_text("J. Smith. A b. c."), "J. Smith. A b. c.");
}

TEST(MoonshineText, KeepsPunctuationAndOneBlank) {
  EXPECT_EQ(typed_text("  Hello,   I am Lena. "), "Hello, I am Lena.");
}

} // namespace
} // namespace parlour::adapters::moonshine
