#include <gtest/gtest.h>

#include "adapters/nlu/grammar/marked_text.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(MarkedText, IsReadWithoutItsMarks) {
  const auto read = read_marks("I am [David](Visitor) from [Comptec](Firm).");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->text, "I am David from Comptec.");
  ASSERT_EQ(read->marks.size(), 2U);
  EXPECT_EQ(read->marks[0].slot, "Visitor");
  EXPECT_EQ(read->text.substr(read->marks[1].begin, 7), "Comptec");
  EXPECT_EQ(read->marks[1].end - read->marks[1].begin, 7U);
}

TEST(MarkedText, IsNoneWhereBracketsDoNotFit) {
  EXPECT_FALSE(read_marks("I am [David]"));
  EXPECT_FALSE(read_marks("I am [David](Visitor"));
  EXPECT_TRUE(read_marks("I am (only) David"));
}

} // namespace
} // namespace parlour::adapters::nlu
