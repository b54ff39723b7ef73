#include <gtest/gtest.h>

#include "tools/bench/nlu/data_trial.hpp"

namespace parlour::tools {
namespace {

using adapters::nlu::NluEngine;

UnderstandingModel model() {
  UnderstandingModel made;
  made.topics = {{"Taxi",
                  false,
                  {{"Destination", "", {}, "", true, false}},
                  {"take me to [Changi](Destination)",
                   "a ride to [Sentosa](Destination)"}},
                 {"Weather", true, {}, {"how is the weather"}}};
  return made;
}

NluEngine engine() {
  return std::move(*NluEngine::build(model(), {}, {0.4, {}}));
}

TEST(DataTrial, CountsWhatIsRight) {
  DataTrial trial;
  trial.add({{"take me to Jurong", "Taxi", {{"Destination", "Jurong"}}},
             {"how is the weather", "Taxi", {}},
             {"xyzzy plugh", "", {}},
             {"how is the weather", "", {}}},
            engine(), NearestExample(model()));
  EXPECT_EQ(trial.asked, 2U);
  EXPECT_EQ(trial.right, 1U);
  EXPECT_EQ(trial.nearest, 1U);
  EXPECT_EQ(trial.frames, 1U);
  EXPECT_EQ(trial.slots.f1(), 100);
  EXPECT_EQ(trial.strangers, 2U);
  EXPECT_EQ(trial.rejected, 1U);
  EXPECT_EQ(trial.texts, 4U);
}

TEST(SlotCount, TakesValuesOrWords) {
  const Value act = Map{
      {"slots", Map{{"Time", Map{{"value", "06:00"}, {"text", "at six"}}},
                    {"Place", Map{{"value", "Sentosa"}, {"text", "centosa"}}},
                    {"Firm", Map{{"value", "x"}, {"text", "polytechnic"}}}}}};
  SlotCount count;
  count.add({"",
             "",
             {{"Time", "at six"},
              {"Place", "Sentosa"},
              {"Firm", "the polytechnic"},
              {"Date", "today"}}},
            act);
  EXPECT_EQ(count.found, 3U);
  EXPECT_EQ(count.right, 3U);
  EXPECT_EQ(count.wanted, 4U);
}

} // namespace
} // namespace parlour::tools
