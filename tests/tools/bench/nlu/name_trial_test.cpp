#include <algorithm>

#include <gtest/gtest.h>

#include "tools/bench/nlu/name_trial.hpp"

namespace parlour::tools {
namespace {

const std::vector<std::string> names{"Jeffery Ho", "Tan Wei Ming",
                                     "Tan Hui Min", "Arun s/o Kumar"};

TEST(NameTrials, MeanOnePerson) {
  const auto trials = name_trials(names);
  EXPECT_GE(trials.size(), 8U);
  EXPECT_LE(trials.size(), 12U);
  EXPECT_EQ(trials[0].said, "Ho Jeffery");
  EXPECT_EQ(trials[0].meant, "Jeffery Ho");
  EXPECT_TRUE(std::ranges::none_of(
      trials, [](const auto& trial) { return trial.said == "Tan"; }));
}

TEST(NameTrials, AreTheSameEachTime) {
  const auto first = name_trials(names);
  const auto second = name_trials(names);
  EXPECT_TRUE(std::ranges::equal(first, second, {}, &NameTrial::said,
                                 &NameTrial::said));
}

TEST(StrangerTrials, AreNobody) {
  const auto strangers = stranger_trials(names);
  ASSERT_EQ(strangers.size(), names.size());
  EXPECT_NE(strangers[1].said.find("Ming"), std::string::npos);
  for (const auto& stranger : strangers)
    EXPECT_EQ(std::ranges::count(names, stranger.said), 0);
}

} // namespace
} // namespace parlour::tools
