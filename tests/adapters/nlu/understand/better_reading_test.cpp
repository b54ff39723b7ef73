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

// With what it has of the sample's values.
Spans spans_of(const Utterance& utterance) {
  std::vector<EntityId> entities{schema().at(0).find("Time")->entity,
                                 schema().at(0).find("Host")->entity};
  std::ranges::sort(entities);
  return {schema(), utterance, entities, sample_now()};
}

// The value of the slot that begins at this token.
Fill value(const std::string& slot, const Spans& spans, std::size_t begin) {
  const auto found = spans.at(schema().at(0).find(slot)->entity, begin);
  EXPECT_FALSE(found.empty());
  const auto& span = spans[found.front()];
  return {slot, 0, found.front(), {}, span.begin, span.end};
}

const Context nothing_known;

bool leaves_open(const std::vector<BuiltAct>& acts,
                 const Utterance& utterance = {}) {
  const auto spans = spans_of(utterance);
  return BetterReading(schema(), nothing_known, utterance, spans, true)
      .leaves_open(acts);
}

bool prefer_better(std::vector<BuiltAct>& acts, const BuiltAct& hypothesis,
                   const Context& context, bool well_taught,
                   const Utterance& utterance = {}) {
  const auto spans = spans_of(utterance);
  return BetterReading(schema(), context, utterance, spans, well_taught)
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
  std::vector<BuiltAct> acts{act(1, 0.7)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.95), {}, true));
  acts = {act(1, 0.5)};
  EXPECT_FALSE(prefer_better(acts, act(0, 0.85), {}, true));
  EXPECT_TRUE(prefer_better(acts, act(0, 0.95), {}, true)); // hardly one
  acts = {act(0, 0.5)};
  EXPECT_TRUE(prefer_better(acts, act(1, 0.9), {}, true));
}

TEST(BetterReading, LosesNoValueThatWasSaid) {
  const Automaton automaton;
  const auto utterance =
      make_utterance("zork the Anand Menon three thirty Hui Min", automaton);
  const auto spans = spans_of(utterance);
  const auto takes = [&](const Fill& said, const Fill& found, double score) {
    std::vector<BuiltAct> acts{act(2, 0.5)};
    acts[0].fills = {said};
    auto hypothesis = act(0, score);
    hypothesis.fills = {found};
    return prefer_better(acts, hypothesis, {}, true, utterance);
  };
  const auto time = value("Time", spans, 4);
  const auto host = value("Host", spans, 2);
  EXPECT_FALSE(takes(time, host, 0.9));
  EXPECT_FALSE(takes(time, fill("Time", 4, 6), 0.9)); // nothing but words
  EXPECT_TRUE(takes(time, time, 0.7));
  EXPECT_TRUE(takes(value("Host", spans, 1), host, 0.7)); // with "the"
  auto given = fill("Time", 0, 8);
  given.literal = Value("08:00"); // that only a rule gave
  EXPECT_TRUE(takes(given, host, 0.7));
  // What may be one of several, or nothing but words, may be none.
  for (const auto& doubtful : {value("Host", spans, 6), fill("Firm", 6, 8)}) {
    EXPECT_FALSE(takes(doubtful, host, 0.8));
    EXPECT_TRUE(takes(doubtful, host, 0.9));
  }
}

TEST(BetterReading, MeansSomethingElseOfTheSameTopic) {
  const auto takes = [](double score, const Context& context) {
    std::vector<BuiltAct> acts{act(1, 0.7)};
    acts[0].fills = {fill("Name", 2, 3)};
    auto hypothesis = act(1, score);
    hypothesis.fills = {fill("Category", 0, 4)};
    hypothesis.fills[0].literal = Value("bank");
    prefer_better(acts, hypothesis, context, true);
    return acts[0].fills[0].slot == "Category";
  };
  EXPECT_TRUE(takes(0.9, {}));
  EXPECT_FALSE(takes(0.8, {}));
  Context expects;
  expects.current = 1;
  EXPECT_FALSE(takes(0.9, expects));
}

// "Get me something to drink": what a rule and what examples give the same
// slot.
TEST(BetterReading, MeansSomethingElseThanARuleGaveByItself) {
  const auto takes = [](bool has_value) {
    std::vector<BuiltAct> acts{act(1, 0.6)};
    acts[0].fills = {fill("Category", 0, 4)};
    acts[0].fills[0].literal = Value("toilet");
    if (has_value)
      acts[0].fills.push_back(fill("Name", 2, 3));
    auto hypothesis = act(1, 0.95);
    hypothesis.fills = {fill("Category", 0, 4)};
    hypothesis.fills[0].literal = Value("bank");
    prefer_better(acts, hypothesis, {}, true);
    return acts[0].fills[0].literal == Value("bank");
  };
  EXPECT_TRUE(takes(false));
  EXPECT_FALSE(takes(true));
}

TEST(BetterReading, KnowsMoreThanAValueThatThereIsNot) {
  const Automaton automaton;
  const auto utterance = make_utterance("to meet the Van", automaton);
  auto spans = spans_of(utterance);
  const auto host = schema().at(0).find("Host")->entity;
  const auto open = spans.open(host, 3, 1);
  ASSERT_FALSE(open.empty());
  auto found = act(0, 0.95);
  found.end = 4;
  const BetterReading better(schema(), nothing_known, utterance, spans, true);
  EXPECT_FALSE(better.leaves_open({found}));
  found.fills = {{"Host", 0, open.front(), {}, 3, 4}};
  EXPECT_TRUE(better.leaves_open({found}));
}

TEST(BetterReading, NeedsMoreBesideAQuestionAboutSomethingElse) {
  Context asks;
  asks.asked_topic = 1;
  const auto takes = [&](double score) {
    std::vector<BuiltAct> acts{act(2, 0.5)};
    return prefer_better(acts, act(0, score), asks, true);
  };
  EXPECT_FALSE(takes(0.8));
  EXPECT_TRUE(takes(0.9));
}

TEST(BetterReading, LeavesASentenceBesideSmallWords) {
  const Automaton automaton;
  const auto utterance = make_utterance("zork is in Tampines now", automaton);
  auto found = act(2, 0.85);
  found.end = 4;
  EXPECT_FALSE(leaves_open({found}, utterance));
  found.end = 3; // "Tampines" is left over
  EXPECT_TRUE(leaves_open({found}, utterance));
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

TEST(BetterReading, TakesThePlaceOfCourtesiesHardlyUnderstood) {
  std::vector<BuiltAct> polite{act(no_topic, 0.5), act(no_topic, 0.6)};
  polite[0].act = "thank";
  polite[1].act = "wait";
  auto acts = polite;
  EXPECT_TRUE(leaves_open(acts));
  EXPECT_FALSE(prefer_better(acts, act(0, 0.8), {}, true)); // not so likely
  EXPECT_EQ(acts.size(), 2U);
  EXPECT_TRUE(prefer_better(acts, act(0, 0.9), {}, true));
  acts = polite;
  acts[1].score = 0.95;
  EXPECT_FALSE(prefer_better(acts, act(0, 0.9), {}, true));
}

TEST(BetterReading, TakesThePlaceOfACorrectionOfNothing) {
  const Automaton automaton;
  const auto utterance = make_utterance("the zork is free", automaton);
  auto spans = spans_of(utterance);
  const auto entity = schema().at(0).find("Host")->entity;
  const auto opened = spans.open(entity, 1, 1);
  ASSERT_FALSE(opened.empty());
  const BetterReading reading(schema(), nothing_known, utterance, spans, true);
  auto corrects = act(0, 0.97, true);
  corrects.act = "correct";
  std::vector<BuiltAct> acts{corrects};
  EXPECT_FALSE(reading.choose(acts, act(1, 0.85)));
  corrects.fills = {{"Host", 0, opened.front(), {}, 1, 2}};
  acts = {corrects};
  EXPECT_TRUE(reading.choose(acts, act(1, 0.85)));
}

TEST(BetterReading, KeepsAValueThatTheMeaningHas) {
  const Automaton automaton;
  const auto utterance = make_utterance("where did Anand Menon go", automaton);
  const auto spans = spans_of(utterance);
  std::vector<BuiltAct> said{act(2, 0.6)};
  said[0].fills = {value("Host", spans, 2)};
  const auto takes = [&](const char* meant) {
    auto acts = said;
    auto hypothesis = act(0, 0.95);
    hypothesis.fills = {{"Host", 0, {}, Value(meant), 0, 5}};
    return BetterReading(schema(), nothing_known, utterance, spans, true)
        .choose(acts, hypothesis);
  };
  EXPECT_TRUE(takes("Anand Menon"));
  EXPECT_FALSE(takes("Priya Nair"));
}

TEST(BetterReading, IsNeededToBeSureOfWhatWasSpokenOfLast) {
  Context context;
  context.completed = 2;
  const auto replaces = [&](double score) {
    std::vector<BuiltAct> acts{act(2, 0.7)};
    return prefer_better(acts, act(0, score), context, true);
  };
  EXPECT_FALSE(replaces(0.85));
  EXPECT_TRUE(replaces(0.95));
  context.current = 2;
  EXPECT_FALSE(replaces(0.95));
}

TEST(BetterReading, LosesNoValueOfNoTopic) {
  const Automaton automaton;
  const auto utterance = make_utterance("it is Anand Menon", automaton);
  const auto spans = spans_of(utterance);
  std::vector<BuiltAct> acts{act(no_topic, 0.5)};
  acts[0].fills = {value("Host", spans, 2)};
  EXPECT_FALSE(BetterReading(schema(), nothing_known, utterance, spans, true)
                   .choose(acts, act(0, 0.9)));
}

} // namespace
} // namespace parlour::adapters::nlu::test
