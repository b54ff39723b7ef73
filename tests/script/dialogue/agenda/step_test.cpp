#include <gtest/gtest.h>

#include "script/dialogue/agenda/step.hpp"

namespace parlour::dialogue {
namespace {

// It is moved often.
TEST(Step, IsSmall) {
  EXPECT_LE(sizeof(Step), 80u);
}

TEST(Step, TellsItsKindAndTheTurnItWorksFor) {
  const Step conclude = steps::Conclude{3};
  EXPECT_TRUE(is<steps::Conclude>(conclude));
  EXPECT_FALSE(is<steps::Run>(conclude));
  EXPECT_EQ(turn_of(conclude), 3u);
  EXPECT_EQ(turn_of(steps::Run{{.turn = 4}}), 4u);
  EXPECT_EQ(turn_of(steps::Leave{2}), 0u);
}

TEST(Step, ItsFieldsAreVisitedInTheTablesOrder) {
  const steps::AskAgain step{.turn = 3, .same_words = true};
  std::vector<std::uint64_t> fields;
  visit_fields(step, [&](auto field) { fields.push_back(field); });
  EXPECT_EQ(fields, (std::vector<std::uint64_t>{3, 1}));
}

TEST(Step, ItsFieldsCanBeFilledIn) {
  steps::Leave step;
  visit_fields(step, [](auto& field) { field = 7; });
  EXPECT_EQ(step.state, 7u);
  steps::End nothing;
  visit_fields(nothing, [](auto&) { FAIL(); });
}

} // namespace
} // namespace parlour::dialogue
