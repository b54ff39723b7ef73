#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// "'words' rule" of the best match, or "".
std::string best(const Stages& stages) {
  const Match* found = nullptr;
  for (const auto& match : stages.matches)
    if (!found || match.score > found->score)
      found = &match;
  return !found ? ""
                : "'" + stages.words(found->begin, found->end) + "' " +
                      stages.automaton.rules[found->rule].name;
}

constexpr const char* grammar = R"(
  public <ask> = where is [the] toilet {act=request};
  public <at> = at @time {Time};
  public <from> = from @words {Organisation};
  public <host> = @db:staff.name {Host};)";

TEST(Matcher, FindsRulesAnywhere) {
  struct {
    const char* text;
    const char* expected;
  } const cases[] = {
      {"", ""},
      {"where is the toilet", "'where is the toilet' <g.ask>"},
      {"hello where is toilet please", "'where is toilet' <g.ask>"},
      {"where er is um the toilet", "'where er is um the toilet' <g.ask>"},
      {"where is that toilet", "'where is that toilet' <g.ask>"},
      {"where is zig zag zog zug toilet", ""}, // too much between
      {"toilet the is where", ""},
      {"come at half past ten", "'at half past ten' <g.at>"},
      {"from Comptec Asia", "'from Comptec Asia' <g.from>"},
      {"dr jeffery ho", "'dr jeffery ho' <g.host>"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_EQ(best(Stages(grammar, text)), expected) << text;
}

TEST(Matcher, PassesOverWordsAtACost) {
  const auto score = [](const char* text) {
    const Stages stages(grammar, text);
    return stages.matches.empty() ? 0 : stages.matches[0].score;
  };
  const auto fluent = score("where is the toilet");
  EXPECT_GT(fluent, score("where is please the toilet"));
  EXPECT_GT(score("where is please the toilet"),
            score("where is at the toilet"));
  EXPECT_GT(score("where is at the toilet"), score("where is zig the toilet"));
  EXPECT_GT(fluent, score("where is, the toilet"));
  EXPECT_GT(score("where is, the toilet"), score("where is. The toilet"));
}

TEST(Matcher, TakesWhatTheContextAsksFor) {
  const auto* bare = "public <answer> = [it is] @asked;";
  EXPECT_EQ(best(Stages(bare, "Ang Mo Kio")), "");
  EXPECT_EQ(
      best(Stages(bare, "Ang Mo Kio", sample_context("Taxi.Destination"))),
      "'Ang Mo Kio' <g.answer>");
}

TEST(Matcher, PrefersWhatFillsMoreThenWhatComesFirst) {
  EXPECT_EQ(best(Stages("public <bare> = call at noon {act=request};"
                        "public <timed> = call at @time {Time};",
                        "call at noon")),
            "'call at noon' <g.timed>");
  EXPECT_EQ(best(Stages("public <one> = call now {act=request};"
                        "public <two> = call now {act=cancel};",
                        "call now")),
            "'call now' <g.one>");
  // Within a rule as well.
  const Stages stages("public <call> = call at (noon | @time {Time});",
                      "call at noon");
  ASSERT_EQ(stages.islands.size(), 1U);
  EXPECT_EQ(stages.islands[0].fills.size(), 1U);
}

// The platform's rules would.
TEST(Matcher, PassesOverANotOnlyForTheApplication) {
  const auto* rule = "public <see> = i see {act=thank};";
  EXPECT_EQ(best(Stages(rule, "I can not see")), "'I can not see' <g.see>");
  EXPECT_EQ(best(Stages(rule, "I can not see", {}, true)), "");
  EXPECT_EQ(best(Stages(rule, "I, er, see", {}, true)), "'I, er, see' <g.see>");
}

TEST(Matcher, BoundsItsWork) {
  const auto work = [](int copies) {
    std::string text;
    for (int copy = 0; copy < copies; ++copy)
      text += "at one from where is ";
    return Stages(grammar, text).matcher.work();
  };
  const auto once = work(10);
  EXPECT_GT(once, 0U);
  EXPECT_LT(work(30), 4 * once); // in proportion to the text
  EXPECT_EQ(work(200), work(400));
}

} // namespace
} // namespace parlour::adapters::nlu::test
