#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "adapters/nlu/understand/hypotheses.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// "do not disturb me" is an order, whatever the topic is that is spoken of.
TEST(Hypotheses, RefuseNothingThatTheLikeliestTopicIsAbout) {
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
TEST(Hypotheses, LeaveAValueToItsOwnSlot) {
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

TEST(Hypotheses, HaveSlotsOfTheirTopic) {
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

// Topics that are known by their examples only, said in other words.
NluEngine learnt() {
  UnderstandingModel model;
  model.topics = {
      {"Taxi",
       false,
       {{"Destination", "", {}, "", true, false},
        {"Time", "time", {}, "", true, false}},
       {"please book a taxi to [Changi Airport](Destination)",
        "I need a cab to [Sentosa](Destination) at [9:00](Time)",
        "order a taxi for [noon](Time)"}},
      {"Weather", true, {}, {"will it rain", "how is the weather outside"}}};
  auto built = NluEngine::build(model, {}, {0.4, {}});
  if (!built)
    throw std::runtime_error(to_string(built.error().front()));
  return std::move(*built);
}

TEST(LearntTopics, AreUnderstoodInOtherWords) {
  const auto engine = learnt();
  EXPECT_EQ(summary(engine.understand("is the weather any good").acts),
            "request Weather");
  EXPECT_EQ(summary(engine.understand("order the cab for noon").acts),
            "inform Taxi Time=12:00");
  EXPECT_TRUE(engine.understand("who won the match").acts.empty());
}

// Who cancels a taxi orders none.
TEST(LearntTopics, AreCalledOff) {
  const auto engine = learnt();
  EXPECT_EQ(summary(engine.understand("please cancel the cab to Sentosa").acts),
            "cancel Taxi");
  EXPECT_EQ(summary(engine.understand("call the taxi off please").acts),
            "cancel Taxi");
  EXPECT_EQ(summary(engine.understand("cancel how is the weather").acts),
            "request Weather"); // that is answered, and does no harm
}

TEST(LearntTopics, MayBeAboutCallingOff) {
  UnderstandingModel model;
  model.topics = {{"Refund",
                   false,
                   {},
                   {"I want to cancel my order", "cancel the order please"}},
                  {"Weather", true, {}, {"will it rain"}}};
  const auto built = NluEngine::build(model, {}, {0.4, {}});
  EXPECT_EQ(summary(built->understand("I must cancel the order").acts),
            "inform Refund");
}

// Nothing of "do you like zork" is about the weather.
TEST(LearntTopics, DoNotGoOnWithWordsThatNobodyKnows) {
  const auto engine = learnt();
  const Map resting{{"resting", "Weather"}};
  const auto score = [&](const char* text, const Map& context) {
    return engine.understand(text, Value(context)).score;
  };
  EXPECT_EQ(score("how is the zork", {}), score("how is the zork", resting));
  EXPECT_LT(score("how is the weather there", {}),
            score("how is the weather there", resting));
}

TEST(LearntTopics, AreNotTriedBesideAQuestionsGrammar) {
  const auto engine = learnt();
  for (const auto* text : {"is the weather any good", "order the cab for noon",
                           "I need a cab to Sentosa at 9:00", "noon"})
    EXPECT_TRUE(
        engine.understand(text, Value(Map{{"grammar", "size"}})).acts.empty())
        << text;
}

TEST(LearntTopics, SayWhatTheyWereLearntAs) {
  const auto lines =
      learnt().understand("order the cab for noon", {}, true).explanation;
  EXPECT_TRUE(std::ranges::any_of(lines, [](const auto& line) {
    return line.starts_with("learnt 0.") || line.starts_with("learnt 1.");
  }));
}

// Thousands of examples are no rules, but their slots are looked at.
TEST(LearntTopics, MayHaveManyExamples) {
  UnderstandingModel model;
  model.topics = {{"Taxi", false, {}, {}}, {"Weather", true, {}, {}}};
  model.topics[0].examples.assign(400, "book a taxi for me");
  model.topics[1].examples.assign(400, "how is the weather");
  const auto built = NluEngine::build(model, {}, {0.4, {}});
  ASSERT_TRUE(built);
  const auto made = built->understand("book a taxi for us");
  EXPECT_EQ(summary(made.acts), "inform Taxi");
  EXPECT_EQ(made.work, 0U);
  model.topics[1].examples[0] = "how is it in [Changi](Place)";
  const auto failed = NluEngine::build(model, {}, {0.4, {}});
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().size(), 1U);
}

// An engine of another time of the same application, whose columns had other
// values: what it has learnt is not learnt again.
TEST(LearntTopics, AreTakenOver) {
  const auto taught = learnt();
  UnderstandingModel model;
  model.topics = {{"Taxi",
                   false,
                   {{"Destination", "", {}, "", true, false},
                    {"Time", "time", {}, "", true, false}},
                   {}},
                  {"Weather", true, {}, {}}};
  const auto built = NluEngine::build(model, {}, {0.4, {}}, &taught);
  ASSERT_TRUE(built);
  EXPECT_EQ(summary(built->understand("is the weather any good").acts),
            "request Weather");
}

// Three hundred wordings of two meanings and a few sentences about nothing,
// beside the sample's grammar.
NluEngine well_taught(std::vector<GrammarModel> generic = {}) {
  const std::vector<std::string> swims{
      "somewhere to swim",   "do some lengths", "take a dip",
      "a swim before lunch", "splash about",    "go swimming"};
  const std::vector<std::string> asks{"need", "want", "would like", "fancy",
                                      "was hoping for"};
  NluEngine::Options options{0.4, std::move(generic)};
  for (int person = 0; person < 10; ++person)
    for (const auto& ask : asks) {
      for (const auto& swim : swims)
        options.wordings.push_back({"Facility",
                                    {{"Category", Value("bank")}},
                                    fmt::format("I {} {}", ask, swim)});
      options.wordings.push_back(
          {"Appointment",
           {},
           fmt::format("I {} a word with [Priya Nair](Host)", ask)});
    }
  options.other_talk = {"who won the match", "what is love",
                        "the capital of France", "how do I fry an egg"};
  auto built = NluEngine::build(sample_model(), sample_column, options);
  if (!built)
    throw std::runtime_error(to_string(built.error().front()));
  return std::move(*built);
}

TEST(Wordings, FillSlotsWithoutTheirValues) {
  const auto engine = well_taught();
  EXPECT_EQ(summary(engine.understand("I really fancy a swim").acts),
            "request Facility Category=bank");
  EXPECT_TRUE(engine.understand("how do I fry a fish").acts.empty());
  EXPECT_TRUE(engine.understand("xyzzy plugh").acts.empty());
}

TEST(Wordings, AreExplainedWithWhatTheyFill) {
  const auto lines =
      well_taught().understand("I really fancy a swim", {}, true).explanation;
  EXPECT_TRUE(std::ranges::any_of(lines, [](const auto& line) {
    return line.starts_with("learnt ") &&
           line.find(" Facility{Category=bank}") != std::string::npos;
  }));
}

TEST(Wordings, MeanNothingWithoutTheValuesThatAllOfThemSay) {
  const auto engine = well_taught();
  EXPECT_EQ(
      summary(
          engine.understand("I was hoping for a word with Priya Nair").acts),
      "inform Appointment Host=Priya Nair");
  EXPECT_FALSE(summary(engine.understand("I was hoping for a word").acts)
                   .starts_with("inform Appointment"));
}

// A yes or no is waited for: more is needed to do something else.
TEST(Wordings, AreDoubtedBesideAYes) {
  const auto engine = well_taught();
  const auto* text = "I was hoping that somebody would";
  EXPECT_FALSE(engine.understand(text).acts.empty());
  EXPECT_TRUE(
      engine.understand(text, Value(Map{{"confirms", "shall I book it"}}))
          .acts.empty());
}

// Beside what is said about the conversation itself.
TEST(Wordings, AreUnderstoodInASentenceOfTheirOwn) {
  const auto engine = well_taught({generic_grammar()});
  const auto heard = [&](const char* text) {
    const Value context(
        Map{{"now", sample_now()}, {"confirms", "Shall I book it?"}});
    return summary(engine.understand(text, context).acts);
  };
  EXPECT_EQ(heard("Yes please. I fancy some lengths."),
            "confirm + request Facility Category=bank");
  EXPECT_EQ(heard("Yes please. My brother is a fish."), "confirm");
  EXPECT_EQ(heard("Is there a toilet? I fancy some lengths."),
            "request Facility Category=toilet");
}

} // namespace
} // namespace parlour::adapters::nlu::test
