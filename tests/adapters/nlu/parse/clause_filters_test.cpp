#include <gtest/gtest.h>

#include "adapters/nlu/parse/clause_filters.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

std::string understood(const char* text, const char* question = nullptr) {
  static const auto engine = sample();
  Map context{{"now", sample_now()}};
  if (question)
    context.set("confirms", question);
  return summary(engine.understand(text, Value(context)).acts);
}

TEST(ClauseFilters, LeaveOutTheStopOfAQuestion) {
  EXPECT_EQ(understood("Where do the taxis stop"), "");
  EXPECT_EQ(understood("and where do the taxis stop?"), "");
  EXPECT_EQ(understood("stop"), "cancel");
  EXPECT_EQ(understood("where are we, stop"), "cancel");
  EXPECT_EQ(understood("the taxis stop"), "cancel");
}

TEST(ClauseFilters, LeaveOutAYesThatIsHalfAClause) {
  EXPECT_EQ(understood("no, wait, it's the bank"),
            "~correct Facility Category=bank");
  EXPECT_EQ(understood("you can ring him"), "");
  EXPECT_EQ(understood("it is"), "confirm");
  EXPECT_EQ(understood("it is, thank you"), "confirm");
  EXPECT_EQ(understood("you can"), "confirm");
  EXPECT_EQ(understood("yes, do it"), "confirm");
  EXPECT_EQ(understood("it is the blue one", "The blue one: is that right?"),
            "confirm");
}

} // namespace
} // namespace parlour::adapters::nlu::test
