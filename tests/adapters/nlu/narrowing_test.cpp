// A grammar that a state or a question names is the only one that is tried.
#include <gtest/gtest.h>

#include "adapters/nlu/understand/nlu_engine.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

TEST(NluEngine, NarrowsToAQuestionsGrammar) {
  auto model = sample_model();
  model.grammars.push_back(
      {"size", "public <size> = (small | large) {Taxi.Destination};", {}});
  const auto built = NluEngine::build(model, sample_column, {});
  ASSERT_TRUE(built);
  const Value context(Map{{"grammar", "size"}});
  EXPECT_EQ(summary(built->understand("small", context).acts),
            "inform Taxi Destination=small");
  EXPECT_EQ(summary(built->understand("is there a bank", context).acts), "");
}

// Neither examples, as rules or as what was learnt, nor values of sets and
// columns, nor names; but what concerns the conversation itself.
TEST(NluEngine, NarrowsExamplesAndValuesToo) {
  auto model = sample_model();
  model.grammars.push_back(
      {"size", "public <size> = (small | large) {Taxi.Destination};", {}});
  const auto built =
      NluEngine::build(model, sample_column, {0.4, {generic_grammar()}});
  ASSERT_TRUE(built);
  const char* const texts[] = {"please book a ride to Bedok at 9:00",
                               "a ride to the airport please",
                               "toilet",
                               "Jeffery Ho",
                               "the coffee shop",
                               "at noon",
                               "no, Jeffery Ho"};
  for (const std::string asked : {"", "Appointment.Host", "Taxi.Destination"}) {
    auto context = *sample_context(asked).if_map();
    context.set("grammar", "size");
    for (const auto* text : texts) {
      const auto acts = summary(built->understand(text, context).acts);
      EXPECT_TRUE(acts.empty() || acts == "deny")
          << acts << ": " << text << ", asked for " << asked;
    }
    EXPECT_EQ(summary(built->understand("help", context).acts), "help");
    EXPECT_EQ(summary(built->understand("cancel that", context).acts),
              "cancel");
    EXPECT_EQ(summary(built->understand("yes", context).acts), "confirm");
  }
  EXPECT_EQ(summary(built->understand("toilet").acts),
            "~request Facility Category=toilet");
}

// Others that fit better, and end at the same word, do not crowd it out.
TEST(NluEngine, NarrowsBeforeItChooses) {
  auto model = sample_model();
  std::string rules;
  for (int rule = 0; rule < 40; ++rule)
    rules += "public <r" + std::to_string(rule) +
             "> = in the hall {Taxi.Destination};";
  model.grammars = {{"many", rules, {}},
                    {"one", "public <hall> = hall {Taxi.Destination};", {}}};
  const auto built = NluEngine::build(model, sample_column, {});
  ASSERT_TRUE(built);
  const Value context(Map{{"grammar", "one"}});
  EXPECT_EQ(summary(built->understand("hall", context).acts),
            "inform Taxi Destination=hall");
  EXPECT_EQ(summary(built->understand("in the hall", context).acts),
            "inform Taxi Destination=hall");
}

} // namespace
} // namespace parlour::adapters::nlu::test
