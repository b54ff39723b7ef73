#include <gtest/gtest.h>

#include "tools/parlour/voice_test/read_aloud.hpp"

namespace parlour::tools {
namespace {

TEST(ReadAloud, says_telephone_numbers_digit_by_digit) {
  EXPECT_EQ(read_aloud("9123 4567"), "9 1 2 3 4 5 6 7");
  EXPECT_EQ(read_aloud("my number is 91234567."),
            "my number is 9 1 2 3 4 5 6 7.");
}

TEST(ReadAloud, leaves_other_numbers) {
  EXPECT_EQ(read_aloud("at 10:30am on level 12"), "at 10:30am on level 12");
  EXPECT_EQ(read_aloud("in 2026"), "in 2026");
  EXPECT_EQ(read_aloud("B1 3 "), "B1 3 ");
  EXPECT_EQ(read_aloud(""), "");
}

TEST(ReadAloud, says_whose_child_somebody_is) {
  EXPECT_EQ(read_aloud("Arun s/o Kumar, Bhavani d/o Menon"),
            "Arun son of Kumar, Bhavani daughter of Menon");
}

} // namespace
} // namespace parlour::tools
