#include <gtest/gtest.h>

#include "script/dialogue/topics/questions.hpp"

namespace parlour::dialogue {

namespace {

using script::no_code;

SlotState asked(std::uint32_t times) {
  SlotState state;
  state.asked = times;
  return state;
}

struct Wording {
  CodeId question;
  std::vector<CodeId> help;
  std::vector<CodeId> expected; // asked 0, 1, 2 … times before
};

class QuestionWording : public testing::TestWithParam<Wording> {};

TEST_P(QuestionWording, IsTheQuestionThenHelpInTurn) {
  script::Slot slot;
  slot.question = GetParam().question;
  slot.help = GetParam().help;
  std::uint32_t times = 0;
  for (auto code : GetParam().expected)
    EXPECT_EQ(question_wording(slot, asked(times++)), code) << times;
}

INSTANTIATE_TEST_SUITE_P(
    All, QuestionWording,
    testing::Values(Wording{1, {}, {1, 1, 1}}, Wording{1, {2}, {1, 2, 2}},
                    Wording{1, {2, 3}, {1, 2, 3, 2, 3}},
                    Wording{no_code, {2, 3}, {2, 3, 2}},
                    Wording{no_code, {}, {no_code, no_code}}));

TEST(Questions, ExplainInTurn) {
  script::Slot slot;
  EXPECT_EQ(explain_wording(slot, asked(1)), no_code);
  slot.explain = {7, 8};
  EXPECT_EQ(explain_wording(slot, asked(0)), 7u);
  EXPECT_EQ(explain_wording(slot, asked(1)), 7u);
  EXPECT_EQ(explain_wording(slot, asked(2)), 8u);
  EXPECT_EQ(explain_wording(slot, asked(3)), 7u);
}

TEST(Questions, ABodyHoldsFromItsCountOn) {
  const std::vector<script::CountedBody> bodies{{2, 5}, {3, 6}};
  EXPECT_EQ(counted_body(bodies, 1), no_code);
  EXPECT_EQ(counted_body(bodies, 2), 5u);
  EXPECT_EQ(counted_body(bodies, 3), 6u);
  EXPECT_EQ(counted_body(bodies, 4), 6u);
  EXPECT_EQ(counted_body({{3, 6}, {1, 4}}, 2), 4u);
  EXPECT_EQ(counted_body({}, 1), no_code);
}

} // namespace

} // namespace parlour::dialogue
