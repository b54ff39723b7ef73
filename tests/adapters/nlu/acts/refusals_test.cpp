#include <gtest/gtest.h>

#include "adapters/nlu/acts/refusals.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

TEST(Refusals, OfWhatNobodyOffersRefuseNothingElse) {
  auto model = sample_model();
  model.grammars[0].text += "public <never> = never zork windows {act=deny};";
  const auto built =
      NluEngine::build(model, sample_column, {0.4, {generic_grammar()}});
  ASSERT_TRUE(built);
  const auto heard = [&](const char* text) {
    return summary(built->understand(text, sample_context("")).acts);
  };
  EXPECT_EQ(heard("I need a taxi, and never zork windows"), "inform Taxi");
  EXPECT_EQ(heard("never zork windows"), "deny");
  // What takes the order back does, and leaves nothing of it.
  EXPECT_EQ(heard("I need a taxi. Don't do that"), "deny");
  EXPECT_EQ(heard("I need a taxi, no, never zork windows"), "deny");
}

TEST(Refusals, AreNoWarnings) {
  static const auto engine = sample();
  const auto heard = [](const char* text, const char* question = nullptr) {
    Map context{{"now", sample_now()}};
    if (question)
      context.set("confirms", question);
    return summary(engine.understand(text, Value(context)).acts);
  };
  EXPECT_EQ(heard("I need a taxi. Don't be late"), "inform Taxi");
  EXPECT_EQ(heard("don't hurry"), "");
  EXPECT_EQ(heard("no, don't hurry"), "deny");
  EXPECT_EQ(heard("don't hurry", "Shall I hurry?"), "deny");
}

} // namespace
} // namespace parlour::adapters::nlu::test
