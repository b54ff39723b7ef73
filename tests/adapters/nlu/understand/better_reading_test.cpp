#include <gtest/gtest.h>

#include "adapters/nlu/understand/better_reading.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

BuiltAct act(TopicNumber topic, double score, bool elliptical = false) {
  BuiltAct made;
  made.act = "inform";
  made.topic = topic;
  made.score = score;
  made.elliptical = elliptical;
  return made;
}

Fill fill(const std::string& slot, std::uint32_t begin, std::uint32_t end) {
  return {slot, 0, {}, {}, begin, end};
}

const Schema& schema() {
  static std::vector<Error> errors;
  static const Schema made(sample_model(), sample_column, errors);
  return made;
}

bool leaves_open(const std::vector<BuiltAct>& acts,
                 const Utterance& utterance = {}) {
  const Context context;
  return BetterReading(schema(), context, utterance, true).leaves_open(acts);
}

bool prefer_better(std::vector<BuiltAct>& acts, const BuiltAct& hypothesis,
                   const Context& context, bool well_taught,
                   const Utterance& utterance = {}) {
  return BetterReading(schema(), context, utterance, well_taught)
      .choose(acts, hypothesis);
}

TEST(BetterReading, TakesThePlaceOfNothing) {
  std::vector<BuiltAct> acts;
  EXPECT_TRUE(leaves_open(acts));
  EXPECT_TRUE(prefer_better(acts, act(0, 0.5), {}, false));
  EXPECT_EQ(acts.size(), 1U);
}

TEST(BetterReading, TakesThePlaceOfAValueOfAnotherTopic) {
  std::vector<BuiltAct> acts{act(1, 0.5, true)};
  EXPECT_TRUE(prefer_better(acts, act(0, 0.6), {}, false));
  EXPECT_EQ(acts[0].topic, 0U);
}

TEST(BetterReading, MakesASentenceOfAValue) {
  std::vector<BuiltAct> acts{act(0, 0.5, true)};
  EXPECT_TRUE(prefer_better(acts, act(0, 0.9), {}, false));
  EXPECT_FALSE(acts[0].elliptical);
  EXPECT_EQ(acts[0].score, 0.9);
}

TEST(BetterReading, LeavesAValueToTheTopicThatIsGoingOn) {
  Context context;
  context.current = 0;
  std::vector<BuiltAct> acts{act(0, 0.7, true)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.9), context, false));
  EXPECT_TRUE(acts[0].elliptical);
}

TEST(BetterReading, DoesNotTakeThePlaceOfASentence) {
  std::vector<BuiltAct> acts{act(1, 0.5)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.9), {}, false));
  EXPECT_EQ(acts[0].topic, 1U);
  EXPECT_FALSE(leaves_open({act(1, 0.95)}));
}

TEST(BetterReading, AddsWhatWasNotFoundYet) {
  std::vector<BuiltAct> acts{act(0, 0.5)};
  acts[0].fills = {fill("Host", 3, 5)};
  auto hypothesis = act(0, 0.9);
  hypothesis.fills = {fill("Visitor", 4, 6), fill("Host", 0, 1),
                      fill("Firm", 6, 7)};
  const Automaton automaton;
  const auto utterance =
      make_utterance("zork one zork two zork three zork four", automaton);
  EXPECT_FALSE(prefer_better(acts, hypothesis, {}, false, utterance));
  ASSERT_EQ(acts[0].fills.size(), 2U);
  EXPECT_EQ(acts[0].fills[1].slot, "Firm");
}

TEST(BetterReading, TakesThePlaceOfADoubtfulSentenceIfItIsWellTaught) {
  const auto replaces = [](double sentence, double hypothesis,
                           const Context& context) {
    std::vector<BuiltAct> acts{act(2, sentence)};
    return prefer_better(acts, act(0, hypothesis), context, true);
  };
  EXPECT_TRUE(replaces(0.5, 0.7, {}));
  EXPECT_FALSE(replaces(0.5, 0.55, {})); // not likely enough
  EXPECT_FALSE(replaces(0.95, 1, {}));   // well understood
  Context expects;
  expects.current = 2;
  EXPECT_FALSE(replaces(0.5, 0.7, expects));
  Context asks;
  asks.asked_topic = 2;
  EXPECT_FALSE(replaces(0.5, 0.7, asks));
}

// Topic 1 is an enquiry.
TEST(BetterReading, BeginsNoTaskInsteadOfAnAnswer) {
  std::vector<BuiltAct> acts{act(1, 0.5)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.9), {}, true));
  acts = {act(0, 0.5)};
  EXPECT_TRUE(prefer_better(acts, act(1, 0.9), {}, true));
}

TEST(BetterReading, LosesNoValueThatWasSaid) {
  auto sentence = act(2, 0.5);
  sentence.fills = {fill("Time", 3, 5)};
  sentence.fills[0].span = 7;
  const auto takes = [&](const Fill& found) {
    std::vector<BuiltAct> acts{sentence};
    auto hypothesis = act(0, 0.9);
    hypothesis.fills = {found};
    return prefer_better(acts, hypothesis, {}, true);
  };
  auto found = fill("Time", 3, 5);
  EXPECT_FALSE(takes(found)); // nothing but words
  found.span = 7;
  EXPECT_TRUE(takes(found));
  sentence.fills[0] = fill("Time", 0, 9);
  sentence.fills[0].literal = Value("08:00"); // that only a rule gave
  EXPECT_TRUE(takes(fill("Host", 1, 2)));
}

// A refusal has no topic.
TEST(BetterReading, ARefusalTakesThePlaceOfNoSentence) {
  std::vector<BuiltAct> acts{act(2, 0.5)};
  EXPECT_FALSE(prefer_better(acts, act(no_topic, 0.9), {}, true));
  EXPECT_EQ(acts[0].topic, 2U);
}

TEST(BetterReading, AGreetingOnlyOpensWhatIsSaid) {
  const Automaton automaton;
  const auto utterance = make_utterance("okay now", automaton);
  for (const auto* about : {"greet", "thank", "confirm"}) {
    std::vector<BuiltAct> acts{act(no_topic, 0.5)};
    acts[0].act = about;
    EXPECT_TRUE(leaves_open(acts, utterance)) << about;
    EXPECT_TRUE(prefer_better(acts, act(0, 0.45), {}, true, utterance))
        << about;
    EXPECT_EQ(acts[0].topic, 0U);
  }
  std::vector<BuiltAct> acts{act(no_topic, 1)};
  acts[0].act = "greet";
  EXPECT_FALSE(leaves_open(acts)); // nothing else is said
}

TEST(BetterReading, AYesThatIsAskedForOpensNothing) {
  Context asks;
  asks.confirms = {"book"};
  std::vector<BuiltAct> acts{act(no_topic, 0.5)};
  acts[0].act = "confirm";
  const Automaton automaton;
  EXPECT_FALSE(prefer_better(acts, act(0, 0.9), asks, true,
                             make_utterance("okay now", automaton)));
}

// Beside what a rule has found.
TEST(BetterReading, AddsNoWordsThatAreNoName) {
  const Automaton automaton;
  const auto utterance =
      make_utterance("it is the big to Tampines now", automaton);
  const auto added = [&](std::uint32_t begin, std::uint32_t end) {
    std::vector<BuiltAct> acts{act(0, 0.95)};
    auto hypothesis = act(0, 0.9);
    hypothesis.fills = {fill("Firm", begin, end)};
    prefer_better(acts, hypothesis, {}, true, utterance);
    return acts[0].fills.size();
  };
  EXPECT_EQ(added(5, 6), 1U);
  EXPECT_EQ(added(5, 7), 0U);
  EXPECT_EQ(added(0, 4), 0U);
}

TEST(BetterReading, AWordThatAsksIsNotLeft) {
  const Automaton automaton;
  const auto utterance =
      make_utterance("and Macbeth, when does that come", automaton);
  auto found = act(2, 0.97);
  found.end = 2;
  EXPECT_TRUE(leaves_open({found}, utterance));
  std::vector<BuiltAct> acts{found};
  EXPECT_TRUE(prefer_better(acts, act(0, 0.7), {}, true, utterance));
  found.end = 6;
  EXPECT_FALSE(leaves_open({found}, utterance));
}

TEST(BetterReading, LeavesANoAndWhoWantsAPerson) {
  for (const auto* about : {"person", "deny", "correct"}) {
    std::vector<BuiltAct> acts{act(no_topic, 0.5)};
    acts[0].act = about;
    EXPECT_FALSE(leaves_open(acts)) << about;
    EXPECT_FALSE(prefer_better(acts, act(0, 0.9), {}, true)) << about;
  }
  std::vector<BuiltAct> acts{act(no_topic, 0.5)};
  acts[0].act = "repeat";
  EXPECT_TRUE(prefer_better(acts, act(0, 0.9), {}, true));
}

TEST(BetterReading, AnExpectedValueNeedsMuchMore) {
  Context context;
  context.resting = 2;
  std::vector<BuiltAct> acts{act(2, 0.6, true)};
  acts[0].fills = {fill("Time", 0, 1)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.85), context, true));
  EXPECT_TRUE(prefer_better(acts, act(0, 0.95), context, true));
  context.asked_topic = 2;
  acts = {act(2, 0.3, true)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.95), context, true));
}

} // namespace
} // namespace parlour::adapters::nlu::test
