#include <gmock/gmock.h>

#include "adapters/nlu/parse/open_words.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

const char* const grammar =
    "#JSGF V1.0; grammar g; public <r> = a taxi to the airport;";

// Of tokens [begin, end) of an answer, or of a sentence.
double certainty(const std::string& said, std::uint32_t begin, bool bare) {
  const Stages stages(grammar, said);
  const auto end = static_cast<std::uint32_t>(stages.utterance.size());
  return certainty_of_words(stages.utterance, {{begin, end}, {0, end}, bare});
}

TEST(OpenWords, NewWordsAreAValue) {
  EXPECT_EQ(certainty("David Okafor", 0, true), 1);
  EXPECT_EQ(certainty("go to Marina Bay", 2, false), 1);
}

TEST(OpenWords, SentencesAreInDoubt) {
  EXPECT_EQ(certainty("what you have to look up", 0, true), 0.6);
  EXPECT_EQ(certainty("from what nobody told me", 1, false), 0.6);
}

TEST(OpenWords, AnAnswerOfWordsThatMeanSomethingElseIsInDoubt) {
  EXPECT_EQ(certainty("taxi airport", 0, true), 0.6);
  EXPECT_EQ(certainty("go to taxi airport", 2, false), 1);
}

TEST(OpenWords, ALongAnswerIsInDoubt) {
  EXPECT_EQ(certainty("green grass grows along every river", 0, true), 0.6);
}

// "Airport, and …": what follows in another clause is something else.
TEST(OpenWords, AnAnswerComesFirst) {
  const auto certainty = [](const char* said, TokenRange value) {
    const Stages stages(grammar, said);
    return certainty_of_words(stages.utterance, {value, value, true});
  };
  EXPECT_EQ(certainty("airport, zork zork", {0, 1}), 0.6);
  EXPECT_EQ(certainty("airport zork zork", {0, 1}), 0.2);
  EXPECT_EQ(certainty("zork zork, airport", {2, 3}), 0.2);
}

// "Before that, a taxi to the airport": no name.
TEST(OpenWords, APartOfWhatIsSaidIsNoAnswerIfItMayMeanSomethingElse) {
  const Stages stages(grammar, "airport zork zork");
  EXPECT_EQ(certainty_of_words(stages.utterance, {{0, 1}, {0, 1}, true}), 0.2);
  EXPECT_EQ(certainty_of_words(stages.utterance, {{1, 3}, {1, 3}, true}), 1);
}

TEST(OpenWords, WhoSomebodyIsLooksLikeAName) {
  EXPECT_EQ(certainty("I'm Bogdan", 2, false), 1);
  EXPECT_EQ(certainty("i am bogdan", 2, false), 1);
  EXPECT_EQ(certainty("Hello, I'm Ah Ming", 3, false), 1);
  EXPECT_EQ(certainty("i am supposed", 2, false), 0.2);
  EXPECT_EQ(certainty("i am waiting for a friend", 2, false), 0.2);
  EXPECT_EQ(certainty("Well, I'm exhausted", 3, false), 0.2);
}

// What is left for Visitor, the slot that is asked for.
std::vector<std::string> visitors(const std::string& said) {
  const Stages stages("#JSGF V1.0; grammar g;"
                      "public <wait> = (one moment | hold on) {act=wait};"
                      "public <no> = no {act=deny};"
                      "public <not> = not {act=deny} {denies=next};"
                      "public <answer> = [i am | that is] @asked;"
                      "public <when> = @time {Appointment.Time};"
                      "public <gym> = where is the gym {topic=Facility} "
                      "{act=request};",
                      said, sample_context("Appointment.Visitor"));
  auto islands = stages.islands;
  drop_implausible(islands, stages.utterance, stages.spans);
  std::vector<std::string> made;
  for (const auto& island : islands)
    if (island.asked)
      made.push_back(stages.words(island.fills[0].begin, island.fills[0].end));
  return made;
}

TEST(OpenWords, WhoWaitsAnswersInAClauseOfItsOwnOnly) {
  using testing::Contains;
  using testing::IsEmpty;
  EXPECT_THAT(visitors("One moment, I've got it written down somewhere"),
              IsEmpty());
  EXPECT_THAT(visitors("Hold on, my card"), IsEmpty());
  EXPECT_THAT(visitors("one moment, the card"), IsEmpty());
  EXPECT_THAT(visitors("Hold on, I am Bogdan"), Contains("Bogdan"));
  EXPECT_THAT(visitors("hold on, that is bogdan"), Contains("bogdan"));
}

TEST(OpenWords, TheEndOfAnotherSentenceIsNoAnswer) {
  EXPECT_THAT(visitors("where is the gym for a friend"),
              testing::Not(testing::Contains("friend")));
  EXPECT_THAT(visitors("where is the gym, zork"), testing::Contains("zork"));
  EXPECT_THAT(visitors("where is the gym Zork"), testing::Contains("Zork"));
}

TEST(OpenWords, LettersAreAWord) {
  const auto tokens = tokenize("that is T H I J S");
  EXPECT_TRUE(is_spelt(tokens, {2, 7}));
  EXPECT_FALSE(is_spelt(tokens, {1, 7}));
  EXPECT_FALSE(is_spelt(tokens, {5, 7}));
  EXPECT_EQ(spelt_word(tokens, {2, 7}), "Thijs");
  EXPECT_THAT(visitors("that is T H I J S"), testing::Contains("T H I J S"));
}

// How many islands give words for the visitor.
std::ptrdiff_t visitors_to_the_end(const std::string& said) {
  const Stages stages(R"(
    public <greet> = (hi | hello) {act=greet};
    public <hi> = (hi | hello | i am) @words {Visitor} {topic=Appointment};
    public <host> = @db:staff.name {Host} {topic=Appointment};
    public <when> = @date {Date} {topic=Appointment};
    public <like> = like (this | that) @words {Visitor} {topic=Appointment};)",
                      said, sample_context(""));
  auto islands = stages.islands;
  // As the engine's rule for a slot's values is.
  RuleInfo bare;
  bare.bare = true;
  for (auto& island : islands)
    if (island.find("Host"))
      island.rule = &bare;
  drop_implausible(islands, stages.utterance, stages.spans);
  return std::ranges::count_if(islands, [&](const Island& island) {
    const auto* fill = island.find("Visitor");
    return fill && fill->end == stages.utterance.size();
  });
}

TEST(OpenWords, AreNoNameOfAListBehindAGreeting) {
  EXPECT_EQ(visitors_to_the_end("hi, Anand Menon"), 0);
  EXPECT_EQ(visitors_to_the_end("hi, Anand Okafor"), 1);
  EXPECT_EQ(visitors_to_the_end("I am Anand Menon"), 1); // who it is, is said
}

TEST(OpenWords, AreNoNameBehindAGreetingIfTheyDoNotLookLikeOne) {
  EXPECT_EQ(visitors_to_the_end("Hello Ravi Okafor"), 1);
  EXPECT_EQ(visitors_to_the_end("hello ravi okafor"), 1);
  EXPECT_EQ(visitors_to_the_end("Hello parcel"), 0);
  EXPECT_EQ(visitors_to_the_end("hello my zork"), 0);
  EXPECT_EQ(visitors_to_the_end("Hello, the screen is dark"), 0);
  EXPECT_EQ(visitors_to_the_end("I am ravi okafor"), 1); // it is said
}

TEST(OpenWords, AreNoPartOfADate) {
  EXPECT_EQ(visitors_to_the_end("like this afternoon"), 0);
  EXPECT_EQ(visitors_to_the_end("like this okafor"), 1);
}

} // namespace
} // namespace parlour::adapters::nlu::test
