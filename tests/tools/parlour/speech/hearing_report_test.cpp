#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/text/json_text.hpp"
#include "tools/parlour/speech/hearing_report.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;
using testing::Not;

HearingReport report() {
  HearingReport made{"question.wav", "SphinxASR", {}, {}};
  made.heard.length = 5'300;
  made.heard.level.add(std::vector<adapters::Sample>{16'384, -16'384});
  made.heard.speech = {{1'000, 2'500}};
  HeardTurn turn{1'000, 2'500};
  turn.partials = {{1'400, "open", false}, {1'800, "open the window", true}};
  turn.text = "open the window";
  turn.confidence = 0.75;
  turn.alternatives = {"open the window", "open a window"};
  turn.words = {Map{
      {"word", "the"}, {"begin", 1'200}, {"end", 1'300}, {"agreed", false}}};
  made.heard.turns = {turn};
  made.understood = {{{"inform {Thing: window}"}, {"window: value of Thing"}}};
  return made;
}

TEST(HearingReportTest, IsForPeople) {
  EXPECT_EQ(report_text(report(), false),
            "question.wav: 5.30 s, level -6 dB, peak -6 dB\n"
            "  speech 1.00 to 2.50 s\n"
            "  turn 1 1.00 to 2.50 s, by SphinxASR\n"
            "    1.40 s       open  (cannot end here)\n"
            "    1.80 s       open the window  (may end here)\n"
            "    heard        open the window\n"
            "    confidence   0.75\n"
            "    by grammar   open the window\n"
            "    by words     open a window\n"
            "    understood   inform {Thing: window}\n");
}

TEST(HearingReportTest, SaysWhy) {
  const auto text = report_text(report(), true);
  EXPECT_THAT(text, HasSubstr("    word         the  1.20 to 1.30 s  "
                              "(not agreed)\n"));
  EXPECT_THAT(text, HasSubstr("    why          window: value of Thing\n"));
}

TEST(HearingReportTest, ShowsOtherHypotheses) {
  auto other = report();
  other.heard.turns[0].alternatives = {
      Map{{"text", "open the willow"}, {"confidence", 0.4}}};
  other.understood[0].acts.clear();
  const auto text = report_text(other, false);
  EXPECT_THAT(text, HasSubstr("    or           open the willow (0.4)\n"));
  EXPECT_THAT(text, HasSubstr("    understood   nothing\n"));
}

TEST(HearingReportTest, TellsWhatWasRejected) {
  auto other = report();
  other.heard.turns[0].rejected = "nothing was understood";
  const auto text = report_text(other, true);
  EXPECT_THAT(text, HasSubstr("    rejected     nothing was understood\n"));
  EXPECT_THAT(text, Not(HasSubstr("understood   ")));
  other.heard.turns.clear();
  other.heard.speech.clear();
  EXPECT_THAT(report_text(other, true), HasSubstr("no speech was found\n"));
}

TEST(HearingReportTest, TellsWhatWakesIt) {
  auto other = report();
  other.heard.sleeps = true;
  EXPECT_THAT(report_text(other, false),
              HasSubstr("  no keyword was said, so it sleeps"));
  other.heard.keywords = {{700, "hey parlour", 0.9}};
  const auto text = report_text(other, false);
  EXPECT_THAT(text, HasSubstr("  keyword 0.70 s \"hey parlour\" (0.90)\n"));
  EXPECT_THAT(text, Not(HasSubstr("sleeps")));
  EXPECT_EQ(report_value(other)["keywords"].at(0)["at_ms"], Value(700));
}

TEST(HearingReportTest, IsForPrograms) {
  const auto value = report_value(report());
  const auto read = read_json(json_text(value));
  ASSERT_TRUE(read);
  EXPECT_EQ(to_string(*read), to_string(value));
  const auto& turn = value["turns"].at(0);
  EXPECT_EQ(turn["text"], Value("open the window"));
  EXPECT_EQ(turn["partials"].at(1)["ends"], Value(true));
  EXPECT_EQ(turn["acts"].at(0), Value("inform {Thing: window}"));
  EXPECT_EQ(value["length_ms"], Value(5'300));
  auto other = report();
  other.heard.turns[0].rejected = "noise";
  EXPECT_EQ(report_value(other)["turns"].at(0)["rejected"], Value("noise"));
}

} // namespace
} // namespace parlour::tools
