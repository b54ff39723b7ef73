#include <gtest/gtest.h>

#include "tools/bench/nlu/nearest_example.hpp"

namespace parlour::tools {
namespace {

TEST(NearestExample, SharesMostWords) {
  UnderstandingModel model;
  model.topics = {{"Taxi", false, {}, {"take me to [Changi](Place)"}},
                  {"Weather", true, {}, {"How's the weather?", "to rain"}}};
  const NearestExample nearest(model);
  EXPECT_EQ(nearest.topic("take him to Changi"), "Taxi");
  EXPECT_EQ(nearest.topic("the WEATHER, please"), "Weather");
  // Of equal counts, the shorter example shares the larger part.
  EXPECT_EQ(nearest.topic("to"), "Weather");
  // The name of a slot is no word.
  EXPECT_EQ(nearest.topic("place"), "");
}

} // namespace
} // namespace parlour::tools
