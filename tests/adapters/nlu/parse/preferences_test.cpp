#include <gtest/gtest.h>

#include "adapters/nlu/parse/preferences.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// "Let me see": where a rule of the application only guesses that somebody is
// called See, the platform's stays.
TEST(Preferences, TakeNoGuessOfTheApplication) {
  RuleInfo waits;
  waits.generic = true;
  RuleInfo meets;
  const auto left = [&](double own) {
    std::vector<Island> islands(2);
    islands[0].rule = &waits;
    islands[0].act = "wait";
    islands[0].score = 1.5;
    islands[1].rule = &meets;
    islands[1].topics = {0};
    islands[1].score = own;
    for (auto& island : islands)
      island.end = 3;
    prefer_application(islands);
    return islands.size();
  };
  EXPECT_EQ(left(0.4), 2U);
  EXPECT_EQ(left(1.5), 1U);
}

TEST(Preferences, TakeTheWordsOfARuleForNoDate) {
  const auto best = [](const std::string& text, bool same_topic = true) {
    const std::string topic = same_topic ? "Appointment" : "Facility";
    Stages stages("public <date> = [on] @date {Date} {topic=Appointment};"
                  "public <day> = this afternoon {" +
                      topic + (same_topic ? ".Visitor" : ".Name") +
                      "=Matinee};",
                  text, sample_context(""));
    auto islands = stages.islands;
    prefer_literals(islands, stages.spans);
    return std::ranges::max_element(islands, {}, &Island::score)->rule->name;
  };
  EXPECT_EQ(best("this afternoon"), "<g.day>");
  EXPECT_EQ(best("this morning"), "<g.date>");
  // It says more than the rule has.
  EXPECT_EQ(best("on this afternoon"), "<g.date>");
  EXPECT_EQ(best("this afternoon", false), "<g.date>");
}

} // namespace
} // namespace parlour::adapters::nlu::test
