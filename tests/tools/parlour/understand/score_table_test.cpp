#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/understand/score_table.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::HasSubstr;

MarkedSentence marked(const std::string& text, const std::string& topic,
                      Map slots = {}) {
  return {1, text, topic, "", std::move(slots), {}};
}

Value act(const Value& topic, const char* name, Map slots = {}) {
  return Map{{"topic", topic}, {"act", name}, {"slots", std::move(slots)}};
}

Map slot(const char* name, const char* value) {
  return Map{{name, Map{{"value", value}}}};
}

TEST(ScoreTable, CountsIntentsSlotsAndFrames) {
  ScoreTable table;
  table.add(marked("a cab at six", "Taxi", {{"Time", "06:00"}}),
            {act("Taxi", "inform", slot("Time", "06:00"))}, 1);
  // The intent is right, a slot is wrong.
  table.add(marked("a cab at ten", "Taxi", {{"Time", "10:00"}}),
            {act("Taxi", "inform", slot("Time", "22:00"))}, 0.5);
  table.add(marked("where is it", "Way"), {act("Taxi", "inform")}, 0.9);
  table.add(marked("moo", ""), {}, 0);
  EXPECT_THAT(table.lines(),
              testing::ElementsAre(
                  "sentences 4",
                  "intent    75.0 % (3 of 4); always Taxi: 50.0 %",
                  "rejected  100.0 % (1 of 1)",
                  "slots     F1 50.0 (precision 50.0, recall 50.0); none: 0.0",
                  "frames    50.0 % (2 of 4); always Taxi without slots: 0.0 %",
                  "confused  1 times Way was taken for Taxi",
                  "worst     line 1, 0.90: \"where is it\" is Way, not Taxi",
                  "worst     line 1, 0.50: \"a cab at ten\" is Taxi "
                  "Time=\"10:00\", not Taxi Time=\"22:00\""));
}

TEST(ScoreTable, AFrameSaysNothingElse) {
  ScoreTable table;
  auto yes = marked("yes", "");
  yes.act = "confirm";
  table.add(yes, {act(Value(), "confirm")}, 1);
  table.add(yes, {act(Value(), "deny")}, 1);
  // A second wish, and a slot too many.
  table.add(marked("a cab", "Taxi"),
            {act("Taxi", "inform"), act("Way", "request")}, 1);
  table.add(marked("a cab", "Taxi"),
            {act("Taxi", "inform", slot("Time", "06:00"))}, 1);
  // What greets before it says something is about that.
  table.add(marked("hello a cab", "Taxi"),
            {act(Value(), "greet"), act("Taxi", "inform")}, 1);
  const auto lines = table.lines();
  EXPECT_THAT(lines, Contains(HasSubstr("intent    80.0 % (4 of 5)")));
  EXPECT_THAT(lines, Contains(HasSubstr("frames    40.0 % (2 of 5)")));
}

TEST(ScoreTable, ShowsTheTenSurestMistakes) {
  ScoreTable table;
  EXPECT_THAT(table.lines(), testing::ElementsAre("sentences 0"));
  for (int i = 0; i < 20; ++i)
    table.add(marked(std::to_string(i), "Taxi"), {}, i / 20.0);
  const auto lines = table.lines();
  EXPECT_EQ(std::ranges::count_if(
                lines, [](auto& line) { return line.starts_with("worst"); }),
            10);
  EXPECT_THAT(lines, Contains(HasSubstr("\"19\" is Taxi, not nothing")));
}

} // namespace
} // namespace parlour::tools
