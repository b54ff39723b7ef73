#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

struct Turn {
  const char* asked;
  const char* text;
  const char* expected;
};

std::string understood(const Turn& turn) {
  static const auto engine = sample();
  return summary(engine.understand(turn.text, sample_context(turn.asked)).acts);
}

// A refusal, in whatever words, is never read as a yes.
TEST(Doubt, TakesNoRefusalForAYes) {
  for (const auto* text : {"absolutely not",
                           "no way",
                           "not at all",
                           "of course not",
                           "I'd rather not",
                           "certainly not",
                           "definitely not",
                           "not now",
                           "not really",
                           "never",
                           "no chance",
                           "please don't",
                           "don't do it",
                           "I don't think so",
                           "I do not",
                           "I'm afraid not",
                           "probably not",
                           "that's not ok",
                           "that is not right",
                           "not quite",
                           "no, sorry",
                           "absolutely no way",
                           "I will not",
                           "rather not",
                           "nope",
                           "no no no"})
    EXPECT_EQ(understood({"", text, ""}), "deny") << text;
}

// Nor is what could be either, or has more to it than is understood.
TEST(Doubt, TakesNoDoubtForAYes) {
  for (const auto* text : {"yes no wait",
                           "yes and no",
                           "no wait, yes",
                           "yes, hold on",
                           "I'm not sure",
                           "not sure",
                           "are you sure?",
                           "is that right?",
                           "right?",
                           "yes but",
                           "yes, maybe",
                           "perhaps yes",
                           "yes if it is cheap",
                           "yes, unless it rains",
                           "ok never mind that purple thing",
                           "no problem",
                           "sure, as if",
                           "that is certainly not at all right",
                           "not bad",
                           "yes, only tomorrowish",
                           "ok so who pays",
                           "right, who are you",
                           "yeah right, zork"})
    EXPECT_THAT(understood({"", text, ""}),
                testing::Not(testing::HasSubstr("confirm")))
        << text;
}

TEST(Doubt, TakesAYesInManyWords) {
  for (const auto* text : {"yes",
                           "yes please",
                           "yeah sure",
                           "ok",
                           "of course",
                           "yes I do",
                           "yes, I am sure",
                           "yes that would be nice",
                           "yes, that is fine with me",
                           "er, yes, please",
                           "why not",
                           "go ahead",
                           "please do",
                           "absolutely",
                           "yes, of course, thank you",
                           "that's right",
                           "yes you can",
                           "ok great",
                           "sounds good",
                           "yes, I would like that"})
    EXPECT_EQ(understood({"", text, ""}), "confirm") << text;
}

TEST(Doubt, LetsAQuestionGoBeforeAYes) {
  EXPECT_EQ(understood({"", "ok, what do you mean?", ""}), "rephrase");
  EXPECT_EQ(understood({"", "right, help me please", ""}), "help");
  EXPECT_EQ(understood({"", "no, why do you ask", ""}), "explain");
  EXPECT_EQ(understood({"", "sure, is there a bank", ""}),
            "confirm + request Facility Category=bank");
  EXPECT_EQ(understood({"", "yes, but is there a bank", ""}),
            "request Facility Category=bank");
}

// What is not to be done is not done, whatever the order is.
TEST(Doubt, CarriesOutNoOrderThatIsTurnedRound) {
  for (const auto* text :
       {"do not book a taxi", "please don't book a taxi", "never book a taxi",
        "I don't want to book a taxi", "don't you dare book a taxi",
        "you must not book a taxi", "I do not want a taxi to the airport"})
    EXPECT_EQ(understood({"", text, ""}), "deny") << text;
  for (const auto* text :
       {"don't forget to book a taxi", "why don't you book a taxi",
        "can't you book a taxi"})
    EXPECT_THAT(understood({"", text, ""}), testing::HasSubstr("Taxi")) << text;
}

TEST(Doubt, TakesNoYesWithANegatedOrder) {
  EXPECT_EQ(understood({"", "yes, don't book a taxi", ""}), "");
  EXPECT_EQ(understood({"", "ok, never book a taxi", ""}), "");
}

TEST(Doubt, CancelsNothingThatIsNotToBeCancelled) {
  for (const auto* text : {"do not cancel it", "please don't start over",
                           "don't cancel everything", "never stop"})
    EXPECT_EQ(understood({"", text, ""}), "") << text;
  EXPECT_EQ(understood({"", "no, cancel it", ""}), "deny + cancel");
}

// A topic that takes yes and no as values.
std::string insured(const std::string& text, const Value& context) {
  UnderstandingModel model;
  model.topics = {{"Insurance",
                   false,
                   {{"Wants", "set", {"yes", "no"}, "", true, false}},
                   {"I want to be insured", "[yes](Wants)"}}};
  static const auto built =
      NluEngine::build(model, {}, {0.4, {generic_grammar()}});
  return summary(built->understand(text, context).acts);
}

TEST(Doubt, TakesAYesAsAValueOnlyWhereNoQuestionWantsIt) {
  const Value confirms(Map{{"confirms", "Shall I book the blue room?"}});
  EXPECT_THAT(insured("yes", sample_context("")),
              testing::HasSubstr("inform Insurance Wants=yes"));
  EXPECT_EQ(insured("yes", confirms), "confirm");
  EXPECT_EQ(insured("no thanks", confirms), "deny");
}

// The value that is asked about, with a no somewhere, is none.
TEST(Doubt, TakesNoValueThatIsTakenBack) {
  static const auto engine = sample();
  const auto asked = [](const char* text) {
    auto context = *sample_context("Appointment.Time").if_map();
    context.set("confirms", "Did you say three?");
    return summary(engine.understand(text, Value(context)).acts);
  };
  EXPECT_EQ(asked("yes three not"), "deny");
  EXPECT_THAT(asked("yes, three, don't book it"),
              testing::Not(testing::HasSubstr("Time")));
  EXPECT_THAT(asked("yes three"), testing::HasSubstr("Time=15:00"));
  EXPECT_THAT(asked("not three, four"), testing::HasSubstr("Time=16:00"));
}

// "Yes" and "no" by themselves are for what was asked.
TEST(Doubt, TakesAYesAsAValueOfTheSlotThatWasAskedForOnly) {
  UnderstandingModel model;
  model.topics = {{"Alarm",
                   false,
                   {{"Off", "set", {"yes", "no"}, "", true, false}},
                   {"the alarm rings"}},
                  {"Room",
                   false,
                   {{"Name", "set", {"blue", "red"}, "", true, false},
                    {"Meals", "set", {"yes", "no"}, "", false, false}},
                   {"book a room", "book a room with meals [yes](Meals)"}}};
  const auto built = NluEngine::build(model, {}, {0.4, {generic_grammar()}});
  const auto heard = [&](const char* asked, const char* text) {
    return summary(built->understand(text, sample_context(asked)).acts);
  };
  for (const auto* asked : {"", "Room.Name"}) {
    EXPECT_EQ(heard(asked, "yes"), "confirm") << asked;
    EXPECT_EQ(heard(asked, "yes please"), "confirm") << asked;
    EXPECT_EQ(heard(asked, "no"), "deny") << asked;
  }
  EXPECT_THAT(heard("Alarm.Off", "yes"),
              testing::HasSubstr("inform Alarm Off=yes"));
  EXPECT_THAT(heard("Alarm.Off", "no"),
              testing::HasSubstr("inform Alarm Off=no"));
  EXPECT_THAT(heard("", "book a room with meals yes"),
              testing::HasSubstr("inform Room Meals=yes"));
}

} // namespace
} // namespace parlour::adapters::nlu::test
