#include <gtest/gtest.h>

#include "tools/parlour/conversation_test/expectation.hpp"

namespace parlour::tools {
namespace {

TEST(Expectation, compares_values_as_they_are_written) {
  EXPECT_TRUE(is_as_expected(7, 7));
  EXPECT_TRUE(is_as_expected("7", 7));
  EXPECT_FALSE(is_as_expected(7, 8));
  EXPECT_TRUE(is_as_expected(Value(), Value()));
  EXPECT_FALSE(is_as_expected("", Value()));
}

TEST(Expectation, a_row_is_a_value_or_a_list) {
  ResultSet rows;
  EXPECT_TRUE(cells_of(rows).is_unknown());
  rows.cells = {1};
  EXPECT_EQ(cells_of(rows), Value(1));
  rows.cells = {1, 2};
  EXPECT_EQ(cells_of(rows), Value(List{1, 2}));
}

TEST(Expectation, a_pattern_is_about_all_that_it_matches) {
  Step pattern;
  pattern.kind = StepKind::robot_pattern;
  pattern.text = "(?s).+";
  Step line;
  line.kind = StepKind::robot;
  Step user;
  using Steps = std::vector<Step>;
  const std::deque<std::string> said{"One.", "Two.", "Three."};
  const auto taken = [&](const Steps& steps) {
    return as_lines(outputs_for(steps, said));
  };
  EXPECT_EQ(taken(Steps{pattern}), "One.\nTwo.\nThree.");
  EXPECT_EQ(taken(Steps{pattern, user, line}), "One.\nTwo.\nThree.");
  EXPECT_EQ(taken(Steps{pattern, line}), "One.\nTwo.");
  EXPECT_EQ(taken(Steps{pattern, line, line, line}), "One.");
  EXPECT_EQ(taken(Steps{line}), "One.");
  pattern.text = ".*";
  EXPECT_EQ(taken(Steps{pattern}), "One.");
  pattern.text = "(?s).*Two\\.";
  EXPECT_EQ(taken(Steps{pattern}), "One.\nTwo.");
}

} // namespace
} // namespace parlour::tools
