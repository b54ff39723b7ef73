#include <gtest/gtest.h>

#include "script/dialogue/agenda/step_list.hpp"

namespace parlour::dialogue {
namespace {

steps::Run numbered(TurnId number) {
  return {{.turn = number}};
}

std::vector<TurnId> numbers(const StepList& steps) {
  std::vector<TurnId> found;
  for (const auto& step : steps)
    found.push_back(turn_of(step));
  return found;
}

using Numbers = std::vector<TurnId>;

TEST(StepList, KeepsTheOrder) {
  StepList steps{numbered(2), numbered(3)};
  steps.append(StepList{numbered(4)});
  steps.append(StepList());
  steps.prepend(StepList{numbered(1)});
  steps.prepend(StepList());
  steps.add(steps::Conclude{5});
  EXPECT_EQ(numbers(steps), (Numbers{1, 2, 3, 4, 5}));
  EXPECT_TRUE(is<steps::Conclude>(steps.back()));
}

TEST(StepList, AStepStaysWhereItIs) {
  StepList steps{numbered(2)};
  const auto* place = &*steps.begin();
  auto other = std::move(steps);
  EXPECT_TRUE(steps.empty());
  StepList all{numbered(1)};
  all.append(std::move(other));
  all.take();
  EXPECT_EQ(&all.take()->step, place);
  EXPECT_TRUE(all.empty());
}

TEST(StepList, TakesOutWhatIsWanted) {
  StepList steps{numbered(1), numbered(2), numbered(3), numbered(4)};
  const auto even =
      steps.take_if([](const Step& s) { return turn_of(s) % 2 == 0; });
  EXPECT_EQ(numbers(even), (Numbers{2, 4}));
  EXPECT_EQ(numbers(steps), (Numbers{1, 3}));
  steps.add(numbered(5));
  EXPECT_EQ(numbers(steps), (Numbers{1, 3, 5}));
}

} // namespace
} // namespace parlour::dialogue
