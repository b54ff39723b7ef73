#include <gtest/gtest.h>

#include "tools/bench/nlu/figures.hpp"

namespace parlour::tools {
namespace {

TEST(Figures, TellTheirBars) {
  EXPECT_EQ(at_least(91.26, 91), "91.3 % (bar 91: met)");
  EXPECT_EQ(at_least(90.9, 92.5), "90.9 % (bar 92.5: missed)");
  EXPECT_EQ(at_most(201, 200, " ms"), "201.0 ms (bar 200: missed)");
}

TEST(TrainedEngine, TellsWhatIsWrong) {
  UnderstandingModel model;
  model.topics = {{"Taxi", false, {}, {"a [cab](Nowhere)"}}};
  EXPECT_FALSE(train(model, {}, {}));
  model.topics[0].examples = {"a cab"};
  const auto trained = train(model, {}, {});
  ASSERT_TRUE(trained);
  EXPECT_FALSE(trained->engine.understand("a cab").acts.empty());
}

} // namespace
} // namespace parlour::tools
