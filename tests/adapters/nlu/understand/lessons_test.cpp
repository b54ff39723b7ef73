#include <gmock/gmock.h>

#include "adapters/nlu/understand/lessons.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

class LessonsTest : public testing::Test {
protected:
  Stages stages_{"public <x> = @Appointment.Host | @time;", "hello"};
  Lessons lessons_{stages_.schema, stages_.automaton, nullptr, 100'000};
};

std::vector<Wording> many(const Wording& wording) {
  return std::vector(300, wording);
}

TEST_F(LessonsTest, ExamplesOfATopicHaveOneLabel) {
  auto topic = sample_model().topics[2];
  topic.examples = {"a cab to [Bedok](Destination)", "a ride", "a [ride"};
  ASSERT_TRUE(lessons_.add(topic));
  ASSERT_THAT(lessons_.labels, SizeIs(1));
  EXPECT_TRUE(lessons_.labels[0].takes_any_words);
  EXPECT_THAT(lessons_.labels[0].needs, IsEmpty());
  EXPECT_THAT(lessons_.said, ElementsAre("a cab to bedok", "a ride"));
  EXPECT_THAT(lessons_.tagged, SizeIs(2));
}

TEST_F(LessonsTest, WordingsDifferByConstantsAndByTheSlotsThatTheySay) {
  const std::vector<Wording> wordings{
      {"Facility", {}, "what is there"},
      {"Facility", {{"Category", Value("bank")}}, "I need cash"},
      {"Facility", {{"Category", Value("bank")}}, "an account please"},
      {"Facility", {}, "is there a [bank](Category)"}};
  ASSERT_TRUE(lessons_.add(FurtherLessons{.wordings = wordings}));
  ASSERT_THAT(lessons_.labels, SizeIs(3));
  EXPECT_EQ(lessons_.texts[2].label, 2U);
  EXPECT_THAT(lessons_.labels[2].needs, ElementsAre("Category"));
  EXPECT_THAT(lessons_.tagged, SizeIs(1)); // the one with a mark
  EXPECT_FALSE(lessons_.are_many);
}

TEST_F(LessonsTest, AMarkedValueHasItsKindWhateverTheDatabaseHolds) {
  const std::vector<Wording> wordings{
      {"Appointment", {}, "to see [Zelda Quill](Host)"},
      {"Appointment", {}, "to see [Ann Bo](Host)"}};
  ASSERT_TRUE(lessons_.add(FurtherLessons{.wordings = wordings}));
  const auto kinds = [&](std::size_t at) {
    const auto& features = lessons_.texts[at].features.features;
    return std::ranges::count(features, FeatureClass::kind_of_value, class_of);
  };
  EXPECT_EQ(kinds(0), 1);
  EXPECT_EQ(kinds(1), 1);
}

TEST_F(LessonsTest, FewWordingsLearnNoOtherTalk) {
  const std::vector<std::string> other{"what is the capital of France"};
  const std::vector<Wording> few{{"Taxi", {}, "a cab"}};
  ASSERT_TRUE(lessons_.add(FurtherLessons{few, {}, other}));
  EXPECT_THAT(lessons_.texts, SizeIs(1));
  const auto wordings = many(few[0]);
  ASSERT_TRUE(lessons_.add(FurtherLessons{wordings, {}, other}));
  EXPECT_TRUE(lessons_.are_many);
  EXPECT_EQ(lessons_.texts.back().label, label_of_nothing);
}

// Rules without wordings become one label, which tells no topic.
TEST_F(LessonsTest, RulesWithoutWordingsAreLeftToTheRules) {
  const auto rule = [](const char* word, TopicNumber topic) {
    return SampledSentence{{word, "@0"}, {topic, "inform", {}}, {}};
  };
  std::vector<SampledSentence> rules{rule("cab", 2), rule("bank", 1)};
  for (int times = 0; times < 100; ++times)
    rules.push_back(rule("ride", 2));
  const auto wordings = many({"Taxi", {}, "a cab"});
  ASSERT_TRUE(lessons_.add(FurtherLessons{wordings, rules, {}}));
  ASSERT_THAT(lessons_.labels, SizeIs(2));
  EXPECT_EQ(lessons_.labels[1].topic, no_topic);
  EXPECT_THAT(lessons_.texts, SizeIs(300 + 30 + 1));
  EXPECT_EQ(lessons_.texts[301].label, 2U); // the bank
}

TEST_F(LessonsTest, SaysIfTheyAreTooMany) {
  Lessons small(stages_.schema, stages_.automaton, nullptr, 50);
  const auto wordings = many({"Taxi", {}, "a cab to the harbour please"});
  const auto added = small.add(FurtherLessons{.wordings = wordings});
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().kind, ErrorKind::limit);
}

TEST_F(LessonsTest, SlotsAreThoseOfTheTextsTopic) {
  const std::vector<Wording> wordings{
      {"Taxi", {}, "a cab at [nine](Time)"},
      {"Appointment", {}, "I am [Zelda](Visitor), here at [nine](Time)"}};
  ASSERT_TRUE(lessons_.add(FurtherLessons{.wordings = wordings}));
  lessons_.number_slots();
  EXPECT_THAT(lessons_.slots, ElementsAre("Time", "Visitor"));
  EXPECT_THAT(lessons_.tagged[0].slots, ElementsAre(0U));
  EXPECT_THAT(lessons_.tagged[1].slots, ElementsAre(0U, 1U));
}

} // namespace
} // namespace parlour::adapters::nlu::test
