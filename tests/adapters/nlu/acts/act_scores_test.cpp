#include <gtest/gtest.h>

#include "adapters/nlu/acts/act_scores.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// How much of a yes is understood, to this question.
double understood(const std::string& text, const std::string& question) {
  const Stages stages("public <yes> = yes {act=confirm};", text,
                      Value(Map{{"confirms", question}}));
  const auto chains =
      best_chains(stages.islands, stages.utterance.size(), stages.context);
  std::vector<BuiltAct> acts(1);
  acts[0].act = "confirm";
  acts[0].end = 1;
  set_scores(acts, chains.at(0), stages.utterance, stages.context);
  return acts[0].understood;
}

TEST(ActScores, CountTheWordsOfTheQuestionBesideAYes) {
  const auto* question = "Shall I give up your reservation?";
  EXPECT_GT(understood("yes, give it up", question), 0.7);
  EXPECT_LT(understood("yes, hand it back", question), 0.5);
}

// A greeting makes nothing else clearer, and nothing less clear.
TEST(ActScores, LeaveCourtesiesOut) {
  static const auto engine = sample();
  const auto score = [](const char* text) {
    return engine.understand(text, Value(Map{{"now", sample_now()}})).score;
  };
  EXPECT_GT(score("is there a bank with green zork"), 0);
  EXPECT_EQ(score("is there a bank with green zork"),
            score("hello, is there a bank with green zork"));
  EXPECT_EQ(score("is there a bank with green zork"),
            score("is there a bank with green zork, thank you"));
}

TEST(ActScores, ASentenceIsScoredByItself) {
  static const auto engine = sample();
  const auto acts = [](const char* text) {
    return summary(
        engine.understand(text, Value(Map{{"now", sample_now()}})).acts);
  };
  EXPECT_EQ(acts("What a long and winding story. Where is the bank?"),
            acts("Where is the bank?"));
}

TEST(ActScores, TakeNothingFromARefusalForItsReason) {
  static const auto engine = sample();
  const auto acts = [&](const char* text) {
    return summary(
        engine
            .understand(text, Value(Map{{"now", sample_now()},
                                        {"confirms", "Shall I book it?"}}))
            .acts);
  };
  EXPECT_EQ(acts("No, don't, my brother came along with his big red lorry"),
            "deny");
  EXPECT_EQ(acts("Never mind, my brother came along with his big red lorry"),
            "cancel");
  EXPECT_EQ(acts("No, it's only somebody with leaflets and a silly hat"),
            "deny");
  EXPECT_EQ(acts("Never mind, the sun has come out again over the big hill"),
            "cancel");
  // What is meant instead is no reason, and a yes needs none.
  EXPECT_EQ(acts("No, it's the purple one with stripes and a silly hat"), "");
  EXPECT_EQ(acts("No, the purple one with stripes and a silly hat"), "");
  EXPECT_EQ(acts("No, the purple one will do"), "");
  EXPECT_EQ(acts("Yes, my brother came along with his big red lorry"), "");
}

TEST(ActScores, CountAValueThatIsAllOfASentence) {
  static const auto engine = sample();
  const auto category = [](const char* text) {
    const auto made = engine.understand(text, sample_context(""));
    return made.acts.empty()
               ? std::string()
               : made.acts[0]["slots"]["Category"]["value"].text();
  };
  EXPECT_EQ(category("The toilet. My zorking brother zorks with zorked zorks"),
            "toilet");
  EXPECT_EQ(
      category("The toilet, as always. My brother zorks with zorked zorks"),
      "toilet");
  EXPECT_EQ(
      category("My zorking brother zorks with zorked zorks. I mean toilet"),
      "toilet");
  EXPECT_EQ(category("My brother zorks, the toilet, with big and zorked zorks"),
            "");
}

} // namespace
} // namespace parlour::adapters::nlu::test
