#include "adapters/nlu/understand/hypotheses.hpp"
#include "tests/adapters/nlu/stages.hpp"

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

TEST(Guesses, TakeThePlaceOfNothing) {
  std::vector<BuiltAct> acts;
  EXPECT_TRUE(leaves_open(acts));
  EXPECT_TRUE(prefer_better(acts, act(0, 0.5), schema(), {}));
  EXPECT_EQ(acts.size(), 1U);
}

TEST(Guesses, TakeThePlaceOfAValueOfAnotherTopic) {
  std::vector<BuiltAct> acts{act(1, 0.5, true)};
  EXPECT_TRUE(prefer_better(acts, act(0, 0.6), schema(), {}));
  EXPECT_EQ(acts[0].topic, 0U);
}

TEST(Guesses, MakeASentenceOfAValue) {
  std::vector<BuiltAct> acts{act(0, 0.5, true)};
  EXPECT_TRUE(prefer_better(acts, act(0, 0.9), schema(), {}));
  EXPECT_FALSE(acts[0].elliptical);
  EXPECT_EQ(acts[0].score, 0.9);
}

TEST(Guesses, LeaveAValueToTheTopicThatIsGoingOn) {
  Context context;
  context.current = 0;
  std::vector<BuiltAct> acts{act(0, 0.7, true)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.9), schema(), context));
  EXPECT_TRUE(acts[0].elliptical);
}

TEST(Guesses, DoNotTakeThePlaceOfASentence) {
  std::vector<BuiltAct> acts{act(1, 0.5)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.9), schema(), {}));
  EXPECT_EQ(acts[0].topic, 1U);
  EXPECT_FALSE(leaves_open({act(1, 0.95)}));
}

TEST(Guesses, AddWhatWasNotFoundYet) {
  std::vector<BuiltAct> acts{act(0, 0.5)};
  acts[0].fills = {fill("Host", 3, 5)};
  auto hypothesis = act(0, 0.9);
  hypothesis.fills = {fill("Visitor", 4, 6), fill("Host", 0, 1),
                      fill("Firm", 6, 7)};
  EXPECT_FALSE(prefer_better(acts, hypothesis, schema(), {}));
  ASSERT_EQ(acts[0].fills.size(), 2U);
  EXPECT_EQ(acts[0].fills[1].slot, "Firm");
}

// "do not disturb me" is an order, whatever the topic is that is spoken of.
TEST(Guesses, RefuseNothingThatTheLikeliestTopicIsAbout) {
  Stages stages("public <x> = @time;", "do not disturb me");
  auto topics = sample_model().topics;
  for (auto& topic : topics)
    topic.examples.clear();
  topics[0].examples = {"do not disturb me", "please do not disturb",
                        "don't disturb us now"};
  topics[1].examples = {"disturb me", "you may disturb me now"};
  const auto learned =
      *TrainedModel::train(topics, stages.schema, stages.automaton, 0.4);
  for (const TopicNumber current : {0U, 1U}) {
    auto context = stages.context;
    context.current = current;
    const auto hypotheses = hypothesised_acts(
        learned, stages.utterance, stages.spans, stages.schema, context, 0.1);
    ASSERT_FALSE(hypotheses.empty());
    EXPECT_EQ(hypotheses[0].topic, 0U);
    EXPECT_NE(hypotheses[0].act, "deny");
  }
}

// The tagger would have it that the words behind "meeting with" are the firm.
TEST(Guesses, LeaveAValueToItsOwnSlot) {
  Stages stages("public <x> = @Appointment.Host;", "a meeting with Priya Nair");
  auto topics = sample_model().topics;
  topics[0].examples = {"a meeting with [Comptec](Organisation)",
                        "I have a meeting with [Initech](Organisation)"};
  const auto learned =
      *TrainedModel::train(topics, stages.schema, stages.automaton, 0.4);
  const auto hypotheses =
      hypothesised_acts(learned, stages.utterance, stages.spans, stages.schema,
                        stages.context, 0.4);
  ASSERT_FALSE(hypotheses.empty());
  ASSERT_EQ(hypotheses[0].fills.size(), 1U);
  EXPECT_EQ(hypotheses[0].fills[0].slot, "Host");
}

TEST(Guesses, HaveSlotsOfTheirTopic) {
  Stages stages("public <x> = @Appointment.Host | @time;",
                "a meeting with Priya Nair at ten o'clock");
  auto topics = sample_model().topics;
  topics[0].examples = {"I have a meeting with [Jeffery Ho](Host)"};
  const auto learned =
      *TrainedModel::train(topics, stages.schema, stages.automaton, 0.4);
  const auto hypotheses =
      hypothesised_acts(learned, stages.utterance, stages.spans, stages.schema,
                        stages.context, 0.4);
  ASSERT_FALSE(hypotheses.empty());
  EXPECT_EQ(hypotheses[0].topic, 0U);
  ASSERT_EQ(hypotheses[0].fills.size(), 2U);
  EXPECT_EQ(hypotheses[0].fills[0].slot, "Host");
  EXPECT_EQ(hypotheses[0].fills[1].slot, "Time");
}

} // namespace
} // namespace parlour::adapters::nlu::test
