#include <algorithm>

#include <gtest/gtest.h>

#include "adapters/nlu/understand/rule_sources.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

struct Built {
  explicit Built(const UnderstandingModel& model)
      : schema(model, sample_column, errors), builder(schema, errors) {
    add_rules(model, {{"acts", "public <yes> = yes {act=confirm};", {}}},
              schema, builder, errors);
    automaton = builder.finish();
  }

  auto count(auto is_counted) const {
    return std::ranges::count_if(automaton.rules, is_counted);
  }

  std::vector<Error> errors;
  Schema schema;
  AutomatonBuilder builder;
  Automaton automaton;
};

TEST(RuleSources, AreGrammarsExamplesAndBareValues) {
  const Built built(sample_model());
  EXPECT_TRUE(built.errors.empty());
  EXPECT_EQ(built.count([](const auto& rule) { return rule.generic; }), 1);
  // Of slots that have values of their own.
  EXPECT_EQ(built.count([](const auto& rule) { return rule.bare; }), 8);
  EXPECT_EQ(built.count([](const auto& rule) {
    return rule.name.starts_with("\"Please book");
  }),
            3); // whole, and up to each of its slots
}

TEST(RuleSources, ManyExamplesBecomeNoRules) {
  auto model = sample_model();
  model.topics[2].examples.assign(501, "a ride to [Bedok](Destination)");
  const Built built(model);
  EXPECT_EQ(
      built.count([](const auto& rule) { return rule.name.starts_with('"'); }),
      0);
}

TEST(RuleSources, SlotsOfManyExamplesAreChecked) {
  auto model = sample_model();
  model.topics[2].examples.assign(501, "a ride to [Bedok](Where)");
  EXPECT_FALSE(Built(model).errors.empty());
}

} // namespace
} // namespace parlour::adapters::nlu::test
