#include <algorithm>

#include <gmock/gmock.h>

#include "adapters/nlu/understand/left_out.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Expected<std::vector<std::string>> no_columns(const std::string&) {
  return std::vector<std::string>();
}

TopicModel topic(const std::string& name, std::vector<std::string> examples) {
  return {name, false, {{"To", "", {}, "", true, false}}, std::move(examples)};
}

std::vector<LeftOutExample> left_out(std::vector<TopicModel> topics) {
  UnderstandingModel model;
  model.topics = std::move(topics);
  return read_left_out(model, no_columns, {});
}

LeftOutExample find(const std::vector<LeftOutExample>& all,
                    const std::string& example) {
  const auto found = std::ranges::find(all, example, &LeftOutExample::example);
  return found == all.end() ? LeftOutExample{"missing", example} : *found;
}

const std::vector<std::string> rides{
    "a taxi to [Bedok](To)", "I want a taxi to [Tampines](To)",
    "call a taxi for me", "order a taxi", "we take a taxi"};
const std::vector<std::string> umbrellas{
    "lend me an umbrella", "is there an umbrella", "an umbrella please",
    "do you have an umbrella for me"};

TEST(LeftOut, AnExampleThatIsNotThereIsUnderstoodByTheOthers) {
  const auto all = left_out({topic("Taxi", rides), topic("Rain", umbrellas)});
  ASSERT_EQ(all.size(), rides.size() + umbrellas.size());
  const auto order = find(all, "order a taxi");
  EXPECT_EQ(order.topic, "Taxi");
  EXPECT_TRUE(order.own);
  EXPECT_EQ(order.taken_for, "Taxi");
  EXPECT_GE(order.score, 0.4);
  EXPECT_THAT(order.lone, ElementsAre("order"));
}

TEST(LeftOut, OneThatLooksLikeAnotherTopicsIsTakenForIt) {
  auto strange = umbrellas;
  strange.emplace_back("I want a taxi");
  const auto wrong =
      find(left_out({topic("Taxi", rides), topic("Rain", strange)}),
           "I want a taxi");
  EXPECT_FALSE(wrong.own);
  EXPECT_EQ(wrong.taken_for, "Taxi");
  EXPECT_NE(std::ranges::find(rides, wrong.like), rides.end()) << wrong.like;
}

TEST(LeftOut, WordsOfNoOtherExampleAreNotUnderstood) {
  auto more = rides;
  more.emplace_back("summon the chauffeur");
  const auto alone =
      find(left_out({topic("Taxi", more), topic("Rain", umbrellas)}),
           "summon the chauffeur");
  EXPECT_FALSE(alone.own);
  EXPECT_EQ(alone.taken_for, "");
  EXPECT_EQ(alone.like, "");
  EXPECT_THAT(alone.lone, ElementsAre("chauffeur", "summon"));
}

// Otherwise one would be understood by the other, which is nearly itself.
TEST(LeftOut, ExamplesThatSayTheSameAreLeftOutTogether) {
  const auto all =
      left_out({topic("Taxi", {"summon a chauffeur to [Bedok](To)",
                               "a chauffeur to [Tampines](To), summon him"}),
                topic("Rain", umbrellas)});
  for (const auto& example : all)
    EXPECT_TRUE(example.repeats || example.topic == "Rain") << example.example;
  EXPECT_FALSE(find(all, "lend me an umbrella").repeats);
  EXPECT_FALSE(find(all, "summon a chauffeur to [Bedok](To)").own);
}

TEST(LeftOut, NothingIsToldWithoutExamplesOrAnEngine) {
  EXPECT_THAT(left_out({topic("Taxi", {})}), IsEmpty());
  UnderstandingModel model;
  model.topics = {topic("Taxi", rides)};
  model.grammars = {{"broken", "#JSGF V1.0; grammar x; public <y> = (;", {}}};
  EXPECT_THAT(read_left_out(model, no_columns, {}), IsEmpty());
}

} // namespace
} // namespace parlour::adapters::nlu::test
