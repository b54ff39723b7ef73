#include <gtest/gtest.h>

#include "tools/bench/nlu/frame_trial.hpp"

namespace parlour::tools {
namespace {

UnderstandingModel model() {
  UnderstandingModel made;
  made.topics = {
      {"Visit",
       false,
       {{"Host", "query", {}, "db:staff.name", true, false}},
       {}},
      {"Shop", true, {{"Kind", "set", {"bank"}, "", false, true}}, {}}};
  made.grammars = {
      {"desk",
       "public <meet> = to meet @db:staff.name {Host} "
       "{topic=Visit} {act=inform};\n"
       "public <part> = with @db:staff.name {Host} {topic=Visit};\n"
       "public <ask> = is there a (@Shop.Kind | <cash>) "
       "{topic=Shop} {act=request};\n"
       "<cash> = atm {Kind=bank};",
       {"desk.jsgf", 1, 1}}};
  return made;
}

Expected<std::vector<std::string>> staff(const std::string&) {
  return std::vector<std::string>{"Ada"};
}

TEST(FrameTrials, AreSentencesWithWhatTheyMean) {
  const auto trials = frame_trials(model(), staff, 20);
  ASSERT_EQ(trials.size(), 20U);
  EXPECT_EQ(trials[0].said, "to meet Ada");
  EXPECT_EQ(trials[0].topic, "Visit");
  EXPECT_EQ(trials[0].slots.at("Host"), "Ada");
  for (const auto& trial : trials)
    EXPECT_TRUE(trial.topic == "Visit" || trial.slots.at("Kind") == "bank")
        << trial.said;
}

TEST(FrameTrials, AreTheSameEachTime) {
  const auto first = frame_trials(model(), staff, 20);
  const auto second = frame_trials(model(), staff, 20);
  for (std::size_t at = 0; at < first.size(); ++at)
    EXPECT_EQ(first[at].said, second[at].said);
}

TEST(FrameTrials, AreNoneWithoutAGrammarOrItsColumn) {
  EXPECT_TRUE(frame_trials({}, staff, 5).empty());
  auto visits = model();
  visits.grammars[0].text =
      "public <x> = @db:staff.name {topic=Visit} {act=a};";
  EXPECT_TRUE(frame_trials(visits, nullptr, 5).empty());
}

TEST(Misheard, ChangesSomeWordsOnly) {
  const auto trials = frame_trials(model(), staff, 100);
  const auto heard = misheard(trials);
  std::size_t changed = 0;
  for (std::size_t at = 0; at < trials.size(); ++at)
    changed += heard[at].said != trials[at].said ? 1U : 0U;
  EXPECT_GT(changed, 10U);
  EXPECT_LT(changed, 60U);
  EXPECT_EQ(heard[0].topic, trials[0].topic);
}

} // namespace
} // namespace parlour::tools
