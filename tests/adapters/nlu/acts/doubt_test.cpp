#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/nlu/acts/doubt.hpp"
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

TEST(Doubt, LetsCourtesyStandBesideAnAnswer) {
  for (const auto* text :
       {"yes dear", "yeah go ahead please", "that would be lovely",
        "yes I will", "sure thing boss", "okay sounds good to me"})
    EXPECT_EQ(understood({"", text, ""}), "confirm") << text;
  for (const auto* text : {"no that's all thank you", "no it's fine thank you",
                           "thanks but no thanks", "no need lah"})
    EXPECT_EQ(understood({"", text, ""}), "deny") << text;
  // Behind a yes, but not as a question.
  EXPECT_EQ(understood({"", "sure are you", ""}), "");
  EXPECT_EQ(understood({"", "are you sure", ""}), "");
}

// Yes to a question, and no to what a topic wants.
TEST(Doubt, TakesNoYesBesideANoOfATopic) {
  auto model = sample_model();
  model.grammars[0].text +=
      "public <none> = no taxi [at all] {act=inform} {topic=Taxi};";
  const auto engine =
      NluEngine::build(model, sample_column, {0.4, {generic_grammar()}});
  const auto acts = [&](const char* text) {
    return summary(
        engine
            ->understand(text, Value(Map{{"now", sample_now()},
                                         {"confirms", "Shall I call it?"}}))
            .acts);
  };
  EXPECT_EQ(acts("yes"), "confirm");
  EXPECT_EQ(acts("yes, no taxi at all"), "inform Taxi");
  // What is asked behind it turns no yes round.
  EXPECT_EQ(acts("That's what I said, isn't it? Yes!"), "confirm");
  EXPECT_EQ(acts("yes, I can not"), "");
  // Behind it, the yes itself is asked.
  for (const auto* text : {"ok or not?", "yes, isn't it?", "yes, am I right?",
                           "yes, is that right?"})
    EXPECT_EQ(acts(text), "") << text;
}

std::string answered(const char* text) {
  static const auto engine = sample();
  const Map context{{"now", sample_now()}, {"confirms", "Shall I call it?"}};
  return summary(engine.understand(text, Value(context)).acts);
}

TEST(Doubt, TakesNoAnswerBehindAQuestion) {
  for (const auto* text :
       {"where is the bank, ok?", "where is the bank okay",
        "where is the bank, right?", "where is the bank, all right",
        "where is the bank, no?", "where is the bank, not today?"})
    EXPECT_EQ(answered(text), "request Facility Category=bank") << text;
  EXPECT_EQ(answered("yes, where is the bank?"),
            answered("yes. Where is the bank?"));
  // In a sentence of its own, and behind what is no question, it is one.
  EXPECT_EQ(answered("Where is the bank? Okay"),
            "request Facility Category=bank + confirm");
  EXPECT_EQ(answered("need a taxi, okay"), "inform Taxi + confirm");
}

TEST(Doubt, TakesWhyNotForAYes) {
  for (const auto* text : {"why not", "Why not?", "well, why not?",
                           "why not, thank you", "sure, why not?"})
    EXPECT_EQ(answered(text), "confirm") << text;
  EXPECT_EQ(answered("why not tomorrow?"),
            "~inform Appointment Date=2026-11-22");
  EXPECT_EQ(understood({"", "why not?", ""}), "");
}

TEST(Doubt, CancelsNothingOfTheApplication) {
  EXPECT_EQ(understood({"", "cancel that please", ""}), "cancel");
  EXPECT_EQ(understood({"", "cancel the taxi", ""}), "");
  EXPECT_EQ(understood({"", "never mind, I can take a taxi", ""}), "cancel");
  EXPECT_EQ(understood({"", "stop", ""}), "cancel");
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

// Instead of an answer; the slot that is asked for stays as it is.
TEST(Doubt, TakesNoExcuseForAnAnswer) {
  for (const auto* text :
       {"hold on a moment", "just a second, my phone is ringing",
        "let me look it up", "wait a minute please", "one moment",
        "hang on a second", "I have to think about it"})
    EXPECT_EQ(understood({"Appointment.Visitor", text, ""}), "wait") << text;
  for (const auto* text :
       {"I said that already", "I just told you", "I already told you that",
        "you asked me that already", "how many times do I have to say it",
        "did you not listen"})
    EXPECT_EQ(understood({"Appointment.Visitor", text, ""}), "protest") << text;
  for (const auto* text :
       {"I'd rather not say", "I don't want to tell you",
        "that's none of your business", "it is private",
        "I would prefer not to say where I'm from", "no comment"})
    EXPECT_EQ(understood({"Appointment.Visitor", text, ""}), "refuse") << text;
  for (const auto* text :
       {"what do you need that for", "why do you want to know that",
        "why do you need my phone number", "do you really need to know that",
        "is that really necessary"})
    EXPECT_EQ(understood({"Appointment.Visitor", text, ""}), "explain") << text;
}

// Courtesy is no answer and begins nothing, alone or beside a request.
TEST(Doubt, KnowsCourtesyWhereverItStands) {
  for (const auto* text :
       {"thanks, that's all", "got it, thanks so much", "that's all thank you",
        "bless you", "super, thank you"})
    EXPECT_EQ(understood({"", text, ""}), "thank") << text;
  for (const auto* text :
       {"hello hello, lovely morning isn't it?", "hi there robot",
        "good morning, how are you today?", "did you sleep well"})
    EXPECT_EQ(understood({"", text, ""}), "greet") << text;
  for (const auto* text :
       {"yes dear", "that would be lovely", "yes, that's right, thank you",
        "yes exactly", "yes yes, go on", "perfect", "yes, him", "go ahead"})
    EXPECT_EQ(understood({"", text, ""}), "confirm") << text;
  EXPECT_EQ(understood({"", "I need a taxi. Goodbye!", ""}), "inform Taxi");
}

TEST(Doubt, TakesNoYesThatIsTurnedRound) {
  for (const auto* text : {"yes I can not", "of course you can't",
                           "okay cannot", "yes you may not"}) {
    const auto acts = understood({"", text, ""});
    EXPECT_EQ(acts.find("confirm"), std::string::npos) << text << ": " << acts;
  }
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

// Whoever says his name gives no host, though the host is asked for.
TEST(Doubt, LetsARuleOfTheApplicationGoBeforeAnAnswer) {
  EXPECT_THAT(understood({"Appointment.Host", "my name is Anand Menon", ""}),
              testing::HasSubstr("Visitor=Anand Menon"));
  EXPECT_THAT(understood({"Appointment.Host", "Anand Menon", ""}),
              testing::HasSubstr("Host=Anand Menon"));
  EXPECT_THAT(understood({"Appointment.Host", "it is Anand Menon", ""}),
              testing::HasSubstr("Host=Anand Menon"));
}

TEST(Doubt, LetsNoYesPassOverAName) {
  EXPECT_THAT(understood({"", "Yeah, hi. Anand Menon? He's with IT.", ""}),
              testing::HasSubstr("Host=Anand Menon"));
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
  EXPECT_EQ(understood({"", "ok, never book a taxi", ""}), "deny");
}

TEST(Doubt, CancelsNothingThatIsNotToBeCancelled) {
  for (const auto* text :
       {"do not cancel it", "please don't start over",
        "don't cancel everything", "never stop", "I don't want to cancel",
        "no need to cancel", "I do not want to start over"})
    EXPECT_EQ(understood({"", text, ""}), "") << text;
  EXPECT_EQ(understood({"", "no, cancel it", ""}), "deny + cancel");
}

TEST(Doubt, TakesNoOtherWordsForAYesOrACallForHelp) {
  EXPECT_EQ(understood({"", "is the bank open right now", ""}),
            "~request Facility Category=bank");
  EXPECT_EQ(understood({"", "I don't know him", ""}), "");
  EXPECT_EQ(understood({"Taxi.Phone", "I don't know my number", ""}), "help");
}

TEST(Doubt, TakesAYesBesideTheNumberOfTheQuestion) {
  static const auto engine = sample();
  const auto asked = [](const char* text) {
    auto context = *sample_context("").if_map();
    context.set("confirms", "A call at 8am: shall I set it?");
    return summary(engine.understand(text, Value(context)).acts);
  };
  EXPECT_THAT(asked("yes, eight, that's fine"), testing::HasSubstr("confirm"));
  EXPECT_THAT(asked("yes, nine, that's fine"),
              testing::Not(testing::HasSubstr("confirm")));
}

// The verb of the question is part of a yes; another one is not.
TEST(Doubt, TakesAYesInTheWordsOfTheQuestion) {
  static const auto engine = sample();
  const auto asked = [](const char* question, const char* text) {
    return summary(
        engine.understand(text, Value(Map{{"confirms", question}})).acts);
  };
  EXPECT_EQ(asked("Shall I cancel the call?", "yes, cancel it please"),
            "confirm");
  EXPECT_EQ(asked("Shall I set the call?", "yes, cancel it please"),
            "confirm + cancel");
  EXPECT_EQ(asked("Shall I give up the place?", "yes, give it up"), "confirm");
  EXPECT_EQ(asked("Shall I give up the place?", "yes, give up the other one"),
            "");
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

TEST(Doubt, TakesNoYesThatOnlyOpensSomethingElse) {
  EXPECT_EQ(answered("okay, where is the bank?").find("confirm"), -1UL);
  EXPECT_EQ(answered("yes, where is the bank?").find("confirm"), 0U);
}

TEST(Doubt, TakesAYesThatIsASentenceOfItsOwn) {
  const auto engine = sample();
  const auto heard = [&](const char* text) {
    Map context{{"now", sample_now()}, {"confirms", "Shall I book a taxi?"}};
    return summary(engine.understand(text, Value(context)).acts);
  };
  EXPECT_EQ(heard("Yes please. And the zork, what about it?"), "confirm");
  EXPECT_EQ(heard("Yes please and the zork, what about it"), "");
  EXPECT_EQ(heard("The zork is big. Yes please."), "");
  EXPECT_EQ(heard("Yes. But the zork is big."), "");
  EXPECT_EQ(heard("Yes. Not the zork."), "");
}

} // namespace
} // namespace parlour::adapters::nlu::test
