#include <gtest/gtest.h>

#include "adapters/nlu/parse/act_scores.hpp"
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

} // namespace
} // namespace parlour::adapters::nlu::test
