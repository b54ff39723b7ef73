#include <gtest/gtest.h>

#include "adapters/nlu/acts/named_slot.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// To "What should I change?".
const Map changes{
    {"topic", "Taxi"},
    {"slots", Map{{"Time", "time"}, {"Destination", "goal of the trip"}}}};

std::string named(const std::string& said, const Map& asked = changes) {
  const Stages stages("#JSGF V1.0; grammar g; public <r> = hello;", said,
                      Map{{"changes", asked}});
  const auto act = named_slot_of(stages.utterance, stages.context);
  return act ? act->act + " " + stages.schema.at(act->topic).name + "." +
                   act->fills.at(0).slot
             : "";
}

TEST(NamedSlot, IsToBeAnother) {
  for (const auto* text :
       {"the time", "time", "No, the time.", "change the time please",
        "the time is wrong", "the time is not right", "I want another time",
        "not the time", "can you change the time"})
    EXPECT_EQ(named(text), "correct Taxi.Time") << text;
  EXPECT_EQ(named("the goal of the trip"), "correct Taxi.Destination");
}

TEST(NamedSlot, IsAllThatIsSaid) {
  for (const auto* text :
       {"the time is right", "I have no time", "I need the time",
        "yes, the time", "at what time", "the time, 10:00",
        "the time and the goal of the trip", "the trip", "the day", ""})
    EXPECT_EQ(named(text), "") << text;
}

TEST(NamedSlot, HasTheLongerOfTwoNames) {
  const Map asked{
      {"topic", "Taxi"},
      {"slots", Map{{"Time", "phone"}, {"Destination", "phone number"}}}};
  EXPECT_EQ(named("the phone number", asked), "correct Taxi.Destination");
  EXPECT_EQ(named("the phone", asked), "correct Taxi.Time");
}

TEST(NamedSlot, IsOneOfThoseThatWereAskedAbout) {
  EXPECT_EQ(named("the time", {}), "");
  EXPECT_EQ(named("the time", {{"topic", "Taxi"}}), "");
}

// Understood as a whole, the act says of the slot that it has no value.
TEST(NamedSlot, HasNoValue) {
  static const auto engine = sample();
  const auto acts =
      engine.understand("the time", Value(Map{{"changes", changes}})).acts;
  ASSERT_EQ(acts.size(), 1U);
  const auto slot = acts[0]["slots"]["Time"];
  EXPECT_TRUE(slot["value"].is_unknown());
  EXPECT_EQ(slot["unmatched"], Value(true));
  EXPECT_EQ(slot["text"], Value("time"));
}

TEST(NamedSlot, ComesBehindAChoice) {
  const Stages stages("#JSGF V1.0; grammar g; public <r> = hello;",
                      "the second one",
                      Map{{"asked", Map{{"topic", "Taxi"}, {"slot", "Time"}}},
                          {"choices", List{"9:00", "10:00"}},
                          {"changes", changes}});
  const auto act = choice_or_named_slot(stages.utterance, stages.context);
  ASSERT_TRUE(act);
  EXPECT_EQ(act->fills.at(0).literal, Value("10:00"));
}

} // namespace
} // namespace parlour::adapters::nlu::test
