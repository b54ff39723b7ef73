#include <gtest/gtest.h>

#include "script/dialogue/frame/grounding.hpp"

namespace parlour::dialogue {

namespace {

using script::ConfirmPolicy;

struct Case {
  ConfirmPolicy policy;
  Value confidence;
  Grounding expected;
};

class GroundingOf : public testing::TestWithParam<Case> {};

TEST_P(GroundingOf, FollowsPolicyAndConfidence) {
  EXPECT_EQ(ground(GetParam().policy, GetParam().confidence),
            GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    All, GroundingOf,
    testing::Values(
        Case{ConfirmPolicy::automatic, 0.0, Grounding::reject},
        Case{ConfirmPolicy::automatic, 0.39, Grounding::reject},
        Case{ConfirmPolicy::automatic, 0.4, Grounding::explicitly},
        Case{ConfirmPolicy::automatic, 0.69, Grounding::explicitly},
        Case{ConfirmPolicy::automatic, 0.7, Grounding::implicitly},
        Case{ConfirmPolicy::automatic, 0.89, Grounding::implicitly},
        Case{ConfirmPolicy::automatic, 0.9, Grounding::accept},
        Case{ConfirmPolicy::automatic, 1, Grounding::accept},
        Case{ConfirmPolicy::automatic, Value(), Grounding::implicitly},
        Case{ConfirmPolicy::explicitly, 1.0, Grounding::explicitly},
        Case{ConfirmPolicy::explicitly, Value(), Grounding::explicitly},
        Case{ConfirmPolicy::implicitly, 1.0, Grounding::implicitly},
        Case{ConfirmPolicy::never, 0.1, Grounding::accept}));

} // namespace

} // namespace parlour::dialogue
