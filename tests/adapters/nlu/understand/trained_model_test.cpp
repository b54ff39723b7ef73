#include <set>

#include <gmock/gmock.h>

#include "adapters/nlu/understand/trained_model.hpp"
#include "tests/adapters/nlu/encoder/small_encoder.hpp"
#include "tests/adapters/nlu/stages.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAre;

std::vector<TopicModel> lessons() {
  auto topics = sample_model().topics;
  topics[0].examples = {
      "I have a meeting with [Jeffery Ho](Host)",
      "[Margaret Sim](Host) is waiting for me, I am [David](Visitor)",
      "my name is [David](Visitor) from [Comptec](Organisation)",
      "I am [Mary](Visitor) from [Acme](Organisation)",
      "my name is [Paul](Visitor) and I am from [Initech](Organisation)",
      "this is [Lena](Visitor) from [Hooli](Organisation)"};
  topics[1].examples = {"where can I find a [coffee shop](Category)",
                        "is there any [bank](Category) around"};
  return topics;
}

// How many topics what is learnt tells of for a text.
std::size_t topics_of(const std::string& text) {
  Stages stages("public <x> = hello;", text);
  const auto learned =
      *TrainedModel::train(lessons(), stages.schema, stages.automaton, 0.4);
  return learned.topics(learned.words(stages.utterance, stages.spans)).size();
}

// What is learnt says of a text: the topic, then its slots.
std::string said_of(const std::string& text) {
  Stages stages("public <x> = @Facility.Category | @Appointment.Host;", text);
  const auto learned =
      *TrainedModel::train(lessons(), stages.schema, stages.automaton, 0.4);
  const auto words = learned.words(stages.utterance, stages.spans);
  const auto hypotheses = learned.topics(words);
  const auto hypothesis =
      hypotheses.empty() ? TopicHypothesis() : hypotheses.front();
  auto made = hypothesis.probability < 0.4
                  ? std::string("none")
                  : stages.schema.at(hypothesis.topic).name;
  for (const auto& slot : learned.slots(hypothesis.topic, word_features(words)))
    made += ' ' + slot.slot + '=' + stages.words(slot.begin, slot.end);
  return made;
}

TEST(TrainedModel, TellsTopicsApart) {
  EXPECT_EQ(said_of("where do I find some bank"), "Facility Category=bank");
  EXPECT_EQ(said_of("there is a meeting with Priya Nair"),
            "Appointment Host=Priya Nair");
  EXPECT_EQ(said_of("book a ride for me please").substr(0, 4), "Taxi");
}

TEST(TrainedModel, FindsOpenSlots) {
  EXPECT_EQ(said_of("my name is Wendy from Globex"),
            "Appointment Visitor=Wendy Organisation=Globex");
}

TEST(TrainedModel, RejectsStrangers) {
  EXPECT_EQ(said_of("the").substr(0, 4), "none");
  EXPECT_EQ(said_of("so what is it").substr(0, 4), "none");
}

TEST(TrainedModel, KnowsNothingOfWordsThatNoExampleHas) {
  for (const auto* word : {"foo", "xyzzy", "flurb gnok", "pizza"})
    EXPECT_EQ(topics_of(word), 0U) << word;
  EXPECT_NE(topics_of("waits"), 0U); // as in "waiting"
}

// Beside grammars, a topic whose slots are lists needs more.
TEST(TrainedModel, MostWordsAreKnownBesideGrammars) {
  const auto knows = [](const std::string& rules) {
    Stages stages(rules, "is there any blue tall parrot house");
    auto topics = lessons();
    topics[0].examples.clear();
    topics[2].examples.clear();
    const auto learned =
        *TrainedModel::train(topics, stages.schema, stages.automaton, 0.4);
    return !learned.topics(learned.words(stages.utterance, stages.spans))
                .empty();
  };
  EXPECT_TRUE(knows(""));
  EXPECT_FALSE(knows("public <x> = hello;"));
}

// "cab" stands in no example, and means what "taxi" does.
TEST(TrainedModel, AsksTheEncoderWhereWordsLeaveItUnsure) {
  const parlour::test::TemporaryFolder folder;
  const auto probability = [](std::shared_ptr<const SentenceEncoder> encoder,
                              std::size_t sentences,
                              const std::filesystem::path& known = {},
                              const char* text = "i need a cab") {
    Stages stages("", text);
    auto topics = sample_model().topics;
    topics[0].examples = {"i bank here"};
    topics[1].examples = {"a bank"};
    topics[2].examples = {"i need a taxi", "a taxi"};
    const auto learned = *TrainedModel::train(
        topics, stages.schema, stages.automaton, 0.4, {.sentences = sentences},
        {.encoder = std::move(encoder), .known_sentences = known});
    const auto read =
        learned.topics(learned.words(stages.utterance, stages.spans));
    EXPECT_EQ(stages.schema.at(read.front().topic).name, topics[2].name);
    return read.front().probability;
  };
  const auto by_words = probability({}, 100);
  EXPECT_GT(probability(small::small_encoder(), 100), by_words);
  // Too many examples for it, unless what it makes of them is kept.
  EXPECT_EQ(probability(small::small_encoder(), 3), by_words);
  EXPECT_GT(probability(small::small_encoder(), 3, folder.path() / "known"),
            by_words);
  EXPECT_TRUE(folder.has("known"));
  // Too few words.
  EXPECT_EQ(probability(small::small_encoder(), 100, {}, "taxi cab"),
            probability({}, 100, {}, "taxi cab"));
}

// The same words mean something else: beside grammars, that counts.
TEST(TrainedModel, TakesNothingThatIsLikeNoExampleBesideGrammars) {
  const auto probability = [](const std::string& rules, const char* text) {
    Stages stages(rules, text);
    auto topics = sample_model().topics;
    topics[0].examples.clear();
    topics[1].examples = {"i need a taxi", "a taxi"};
    topics[2].examples = {"bank here"};
    const auto learned =
        *TrainedModel::train(topics, stages.schema, stages.automaton, 0.4, {},
                             {.encoder = small::small_encoder()});
    for (const auto& one :
         learned.topics(learned.words(stages.utterance, stages.spans)))
      if (stages.schema.at(one.topic).name == topics[1].name)
        return one.probability;
    return -1.0;
  };
  const auto* rules = "public <x> = hello;";
  EXPECT_GT(probability(rules, "i need a cab"), 0.1);
  EXPECT_EQ(probability(rules, "i need a bank"), 0);
  EXPECT_GT(probability("", "i need a bank"), 0);
}

TEST(TrainedModel, SaysWhatIsTooMuchToLearn) {
  Stages stages("public <x> = hello;", "hello");
  const auto failure = [&](LearningLimits limits) {
    const auto learned = TrainedModel::train(lessons(), stages.schema,
                                             stages.automaton, 0.4, limits);
    return learned ? "" : learned.error().message;
  };
  EXPECT_THAT(failure({1000, 1 << 20}),
              HasSubstr("there is room for the first 4;"));
  std::set<std::string> all;
  for (std::size_t weights = 1000; weights < 100'000; weights += weights / 4)
    all.insert(failure({1 << 20, weights}));
  EXPECT_THAT(all, UnorderedElementsAre("", HasSubstr("of 3 meanings are too"),
                                        HasSubstr("of 6 slots are too")));
}

TEST(TrainedModel, IsEmptyWithoutExamples) {
  Stages stages("public <x> = hello;", "hello");
  auto topics = sample_model().topics;
  for (auto& topic : topics)
    topic.examples.clear();
  EXPECT_TRUE(TrainedModel::train(topics, stages.schema, stages.automaton, 0.4)
                  ->empty());
}

} // namespace
} // namespace parlour::adapters::nlu::test
