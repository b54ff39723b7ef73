#include <gmock/gmock.h>

#include "adapters/nlu/understand/likeness.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

constexpr const char* rules = R"(#JSGF V1.0; grammar desk;
public <print> = where can i [go to] print [a few] pages {Name=Copy shop}
  {topic=Facility} {act=request};
public <where> = what way leads to @Facility.Category {topic=Facility};
public <cab> = order me a nice cab [to @words {Destination}] {topic=Taxi};
public <find> = anything close by called @words {Name} {topic=Facility};
public <sign> = what is written on the sign of @db:staff.name {Location}
  {topic=Facility} {act=request};
public <meet> = arrange a meeting with @db:staff.name {Host}
  {topic=Appointment};
)";

std::string understood(const char* text, const char* asked = "",
                       double threshold = 0.4,
                       const std::vector<std::string>& other_talk = {},
                       const std::string& further = "") {
  auto model = sample_model();
  model.grammars = {{"desk", rules + further, {}}};
  for (auto& topic : model.topics)
    topic.examples.clear();
  const auto engine = NluEngine::build(
      model, sample_column,
      {.threshold = threshold, .generic = {}, .other_talk = other_talk});
  return engine ? summary(engine->understand(text, sample_context(asked)).acts)
                : to_string(engine.error().front());
}

TEST(Likeness, MuchLikeARuleIsUnderstood) {
  EXPECT_EQ(understood("can pages print here, where"),
            "request Facility Name=Copy shop");
  EXPECT_EQ(understood("purple cows eat pages"), "");
}

TEST(Likeness, ValuesAreTaken) {
  EXPECT_EQ(understood("the bank, what leads to it, which way"),
            "request Facility Category=bank");
  EXPECT_EQ(understood("which way leads to it, what"), "");
}

// Though the slot takes no such values where it is said alone.
TEST(Likeness, ValuesFillTheSlotOfTheRule) {
  EXPECT_EQ(understood("written on sign Priya Nair what"),
            "request Facility Location=Priya Nair");
}

TEST(Likeness, AQuestionAboutAnyWordsIsNotAskedWithoutThem) {
  EXPECT_EQ(understood("what is close by"), "");
}

TEST(Likeness, ATaskWithoutAValueNeedsMore) {
  EXPECT_EQ(understood("cab order nice"), "inform Taxi");
  EXPECT_EQ(understood("cab order for granny"), "");
}

// Who wants to go home prints no pages: the copy shop is only the rule's word.
TEST(Likeness, AValueThatOnlyTheRuleGivesNeedsMore) {
  EXPECT_EQ(understood("can i go home", "", 0.35),
            "request Facility Name=Copy shop");
  EXPECT_EQ(understood("can i go home", "", 0.4), "");
}

TEST(Likeness, MustReachTheThreshold) {
  EXPECT_EQ(understood("can pages print here, where", "", 0.95), "");
}

// Five of them: one may be alike by chance.
const std::vector<std::string> about_taxes{
    "where can i go to pay my tax", "who prints my tax forms",
    "can i print my tax forms", "where are tax forms printed",
    "print my tax forms for may"};

// Rules about so many rooms.
std::string about_rooms(int count) {
  std::string made;
  for (int room = 0; room < count; ++room) {
    const auto name = "room" + std::to_string(room);
    made += "public <" + name + "> = show me " + name + " {Name=" + name +
            "} {topic=Facility} {act=request};\n";
  }
  return made;
}

constexpr auto forms = "where can i print tax forms for last year";

TEST(Likeness, OtherTalkIsAboutNothing) {
  const auto rooms = about_rooms(20);
  EXPECT_NE(understood(forms, "", 0.4, {}, rooms), "");
  EXPECT_EQ(understood(forms, "", 0.4, about_taxes, rooms), "");
  EXPECT_EQ(understood("where can i go to print a few pages", "", 0.4,
                       about_taxes, rooms),
            "request Facility Name=Copy shop");
}

TEST(Likeness, WhatIsExpectedIsNoOtherTalk) {
  const auto rooms = about_rooms(20);
  EXPECT_EQ(understood(forms, "Facility", 0.4, about_taxes, rooms),
            understood(forms, "Facility", 0.4, {}, rooms));
}

TEST(Likeness, FewRulesDoNotTellWhatIsOtherTalk) {
  const auto rooms = about_rooms(10);
  EXPECT_EQ(understood(forms, "", 0.4, about_taxes, rooms),
            understood(forms, "", 0.4, {}, rooms));
}

TEST(Likeness, NegatedOrdersAreLikeNone) {
  EXPECT_EQ(understood("never order me cab nice"), "");
}

} // namespace
} // namespace parlour::adapters::nlu::test
