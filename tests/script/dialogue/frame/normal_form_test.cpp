#include <gtest/gtest.h>

#include "script/dialogue/frame/normal_form.hpp"

namespace parlour::dialogue {

namespace {

struct Case {
  const char* type;
  Value said;
  Value expected; // unknown: refused
};

class NormalForm : public testing::TestWithParam<Case> {};

TEST_P(NormalForm, Is) {
  auto value = normal_form(GetParam().type, GetParam().said);
  EXPECT_EQ(value, GetParam().expected) << to_string(value);
  EXPECT_EQ(value.type(), GetParam().expected.type());
}

const Value refused;

INSTANTIATE_TEST_SUITE_P(
    Time, NormalForm,
    testing::Values(
        Case{"time", "10:30", "10:30"}, Case{"time", "9:05", "09:05"},
        Case{"time", "10:30am", "10:30"}, Case{"time", "10.30 P.M.", "22:30"},
        Case{"time", "12am", "00:00"}, Case{"time", "12:15 pm", "12:15"},
        Case{"time", "3 pm", "15:00"}, Case{"time", "1430", "14:30"},
        Case{"time", "1430hrs", "14:30"}, Case{"time", " 10:30. ", refused},
        Case{"time", "24:00", refused}, Case{"time", "10:60", refused},
        Case{"time", "13pm", refused}, Case{"time", "0am", refused},
        Case{"time", "10", refused}, Case{"time", 10, refused},
        Case{"time", "soon", refused}, Case{"time", Value(), refused}));

INSTANTIATE_TEST_SUITE_P(
    Date, NormalForm,
    testing::Values(Case{"date", "2026-11-21", "2026-11-21"},
                    Case{"date", "21/11/2026", "2026-11-21"},
                    Case{"date", "1.2.2026", "2026-02-01"},
                    Case{"date", "2024-02-29", "2024-02-29"},
                    Case{"date", "2026-02-29", refused},
                    Case{"date", "11/21/2026", refused},
                    Case{"date", "tomorrow", refused}));

INSTANTIATE_TEST_SUITE_P(Number, NormalForm,
                         testing::Values(Case{"number", 3, 3},
                                         Case{"number", " 3 ", 3},
                                         Case{"number", "2.5", 2.5},
                                         Case{"number", "-1", -1},
                                         Case{"number", "three", refused},
                                         Case{"number", true, refused}));

INSTANTIATE_TEST_SUITE_P(
    Duration, NormalForm,
    testing::Values(
        Case{"duration", 90, 90}, Case{"duration", "90", 90},
        Case{"duration", "1h30m", 5400}, Case{"duration", "20 min", 1200},
        Case{"duration", "2 hours 5 minutes", 7500},
        Case{"duration", "1.5s", 1.5}, Case{"duration", -1, refused},
        Case{"duration", "a while", refused}, Case{"duration", "", refused}));

INSTANTIATE_TEST_SUITE_P(
    Level, NormalForm,
    testing::Values(Case{"level", 2, 2}, Case{"level", "-1", -1},
                    Case{"level", "B1", -1}, Case{"level", "L3", 3},
                    Case{"level", "2nd", 2}, Case{"level", "level 12", 12},
                    Case{"level", 2.0, 2}, Case{"level", 2.5, refused},
                    Case{"level", "roof", refused}));

INSTANTIATE_TEST_SUITE_P(
    PhoneAndEmail, NormalForm,
    testing::Values(Case{"phone", "+65 6778-1234", "+6567781234"},
                    Case{"phone", "(02) 6778 1234", "0267781234"},
                    Case{"phone", std::int64_t{67781234}, "67781234"},
                    Case{"phone", "12", refused},
                    Case{"phone", "1234567890123456", refused},
                    Case{"phone", "call me", refused},
                    Case{"phone", "65+12345", refused},
                    Case{"email", " a.b@comptec.com.sg ", "a.b@comptec.com.sg"},
                    Case{"email", "a.b@comptec", refused},
                    Case{"email", "a b@comptec.com", refused},
                    Case{"email", 3, refused}));

TEST(NormalForms, AreKnownByType) {
  EXPECT_TRUE(has_normal_form("time"));
  EXPECT_FALSE(has_normal_form("set"));
  EXPECT_TRUE(normal_form("set", "x").is_unknown());
}

} // namespace

} // namespace parlour::dialogue
