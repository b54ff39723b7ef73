#include <gtest/gtest.h>

#include "tools/bench/nlu/data_trial.hpp"

namespace parlour::tools {
namespace {

using adapters::nlu::NluEngine;

NluEngine engine() {
  UnderstandingModel model;
  model.topics = {{"Taxi",
                   false,
                   {{"Destination", "", {}, "", true, false}},
                   {"take me to [Changi](Destination)",
                    "a ride to [Sentosa](Destination)"}},
                  {"Weather", true, {}, {"how is the weather"}}};
  return std::move(*NluEngine::build(model, {}, {0, {}}));
}

TEST(DataTrial, CountsWhatIsRight) {
  const DataTrial trial(
      {{"take me to Jurong", "Taxi", {{"Destination", "Jurong"}}},
       {"how is the weather", "Taxi", {}},
       {"xyzzy plugh", "", {}}},
      engine());
  EXPECT_EQ(trial.asked, 2U);
  EXPECT_EQ(trial.right, 1U);
  EXPECT_EQ(trial.slots.f1(), 100);
  EXPECT_EQ(trial.scores.size(), 2U);
  EXPECT_EQ(trial.strangers.size(), 1U);
  EXPECT_GT(trial.limit(), trial.strangers[0]);
}

TEST(PercentBelow, LeavesOutTheLimit) {
  EXPECT_EQ(percent_below({0.1, 0.2, 0.3, 0.4}, 0.3), 50);
  EXPECT_EQ(percent_below({}, 0.3), 0);
}

} // namespace
} // namespace parlour::tools
