#include "adapters/nlu/acts/act_value.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

List values(const std::string& text) {
  const Stages stages(sample_grammar, text);
  const auto chains =
      best_chains(stages.islands, stages.utterance.size(), stages.context);
  List made;
  for (const auto& act : build_acts(chains.at(0), stages.utterance,
                                    stages.schema, stages.context, 0.4))
    made.push_back(
        act_value(act, stages.utterance, stages.spans, stages.schema));
  return made;
}

TEST(ActValue, CarriesConfidenceAndWords) {
  const auto made = values("hello, is there a cofee shop");
  ASSERT_EQ(made.size(), 1U);
  EXPECT_EQ(made[0]["text"], Value("is there a cofee shop"));
  const auto slot = made[0]["slots"]["Category"];
  EXPECT_EQ(slot["value"], Value("coffee shop"));
  EXPECT_EQ(slot["text"], Value("cofee shop"));
  EXPECT_LT(slot["confidence"].number_or(-1), 1);
  EXPECT_GT(slot["confidence"].number_or(-1), 0.8);
  EXPECT_LT(made[0]["confidence"].number_or(-1),
            1); // "hello" was not understood
}

TEST(ActValue, KeepsCandidates) {
  const auto made = values("to meet Hui Min");
  ASSERT_EQ(made.size(), 1U);
  const auto slot = made[0]["slots"]["Host"];
  EXPECT_TRUE(slot["value"].is_unknown());
  EXPECT_EQ(slot["candidates"], Value(List{"Ho Hui Min", "Tan Hui Min"}));
}

// A number in words that is no value is told in figures.
TEST(ActValue, WritesNumbersThatDoNotFit) {
  static const auto engine = sample();
  const auto phone = [](const char* text) {
    const auto made = engine.understand(text, sample_context("Taxi.Phone"));
    return made.acts.at(0)["slots"]["Phone"]["value"].text();
  };
  EXPECT_EQ(phone("twelve"), "12");
  EXPECT_EQ(phone("012"), "012");
}

} // namespace
} // namespace parlour::adapters::nlu::test
