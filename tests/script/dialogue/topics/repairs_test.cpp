#include <gtest/gtest.h>

#include "script/dialogue/topics/repairs.hpp"

namespace parlour::dialogue {
namespace {

using script::Repair;

Repair repair(const char* act) {
  Repair made;
  made.act = act;
  return made;
}

// The position's line of the one that is chosen; 0 for none.
std::uint32_t chosen(std::vector<Repair> repairs, const RepairWanted& wanted,
                     bool holds = true) {
  script::Program program;
  program.repairs = std::move(repairs);
  for (std::uint32_t i = 0; i < program.repairs.size(); ++i)
    program.repairs[i].position.line = i + 1;
  const auto* found =
      choose_repair(program, wanted, [&](script::CodeId) { return holds; });
  return found ? found->position.line : 0;
}

TEST(Repairs, TheActDecides) {
  EXPECT_EQ(chosen({repair("help"), repair("repeat")}, {"repeat"}), 2u);
  EXPECT_EQ(chosen({repair("help")}, {"repeat"}), 0u);
  EXPECT_EQ(chosen({repair("help"), repair("help")}, {"help"}), 1u);
}

TEST(Repairs, TheMoreSpecificComesFirst) {
  auto general = repair("help");
  auto topic = repair("help");
  topic.topic = 3;
  topic.of_platform = true;
  auto slot = topic;
  slot.slot = 1;
  EXPECT_EQ(chosen({general, topic, slot}, {"help", 3, 1}), 3u);
  EXPECT_EQ(chosen({general, topic, slot}, {"help", 3, 2}), 2u);
  EXPECT_EQ(chosen({general, topic, slot}, {"help", 4, 1}), 1u);
}

TEST(Repairs, TheApplicationBeforeThePlatformThenAConditionThatHolds) {
  auto platform = repair("help");
  platform.of_platform = true;
  platform.condition = 7;
  auto own = repair("help");
  EXPECT_EQ(chosen({platform, own}, {"help"}), 2u);
  own.condition = 8;
  EXPECT_EQ(chosen({repair("help"), own}, {"help"}), 2u);
  EXPECT_EQ(chosen({repair("help"), own}, {"help"}, false), 1u);
}

TEST(Repairs, AStepHoldsFromItsCountOn) {
  std::vector<Repair> steps(3, repair("no_match"));
  steps[0].count = 1;
  steps[1].count = 3;
  steps[2].count = 0;
  EXPECT_EQ(chosen(steps, {"no_match", 0, 0, 0}), 3u);
  EXPECT_EQ(chosen(steps, {"no_match", 0, 0, 1}), 1u);
  EXPECT_EQ(chosen(steps, {"no_match", 0, 0, 2}), 1u);
  EXPECT_EQ(chosen(steps, {"no_match", 0, 0, 4}), 2u);
  steps[2].topic = 0; // as specific as can be, but for what is not counted
  EXPECT_EQ(chosen(steps, {"no_match", 0, 0, 4}), 2u);
  auto own = repair("no_match");
  own.count = 2;
  for (auto& step : steps)
    step.of_platform = true;
  steps.push_back(own); // and for all that come after it
  EXPECT_EQ(chosen(steps, {"no_match", 0, 0, 1}), 1u);
  EXPECT_EQ(chosen(steps, {"no_match", 0, 0, 4}), 4u);
}

} // namespace
} // namespace parlour::dialogue
