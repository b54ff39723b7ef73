#include <algorithm>

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

class Turns : public testing::TestWithParam<Turn> {};

TEST_P(Turns, AreUnderstood) {
  EXPECT_EQ(understood(GetParam()), GetParam().expected)
      << GetParam().asked << ": " << GetParam().text;
}

// Table I of the paper.
INSTANTIATE_TEST_SUITE_P(
    TableOne, Turns,
    testing::Values(
        Turn{"", "I am David from Comptec to meet Dr. Jeffery Ho.",
             "inform Appointment Visitor=David Organisation=Comptec "
             "Host=Jeffery Ho"},
        Turn{"Appointment.Time",
             "By the way, is there any coffee shop on this second floor?",
             "request Facility Category=coffee shop Location=2"},
        Turn{"Facility", "How about food court?",
             "~request Facility Category=food court"},
        Turn{"Appointment.Time", "10:30am.",
             "~inform Appointment Time=10:30"}));

INSTANTIATE_TEST_SUITE_P(
    OtherWords, Turns,
    testing::Values(
        Turn{"", "hello, my name is Siew Hoon, I'm here to see Mr Anand Menon",
             "inform Appointment Visitor=Siew Hoon Host=Anand Menon"},
        Turn{"", "er where is um the nearest toilet on level b1 please",
             "request Facility Category=toilet Location=-1"},
        Turn{"", "uh to meet Priya Nair at half past two",
             "inform Appointment Host=Priya Nair Time=14:30"},
        Turn{"", "I am Lena to meet Margaret Sim at ten",
             "inform Appointment Visitor=Lena Host=Margaret Sim Time=10:00"},
        Turn{"", "are there... is there bank?",
             "request Facility Category=bank"},
        Turn{"", "please book a ride to Orchard Road at 5pm",
             "inform Taxi Destination=Orchard Road Time=17:00"},
        Turn{"Appointment.Time", "yes, half past two",
             "~inform Appointment Time=14:30"},
        Turn{"Taxi.Destination", "to the airport of course",
             "~inform Taxi Destination=airport"},
        Turn{"", "there's a bank on the first floor, isn't it?",
             "~request Facility Category=bank Location=1"}));

// What is said beside an answer speaks against it.
INSTANTIATE_TEST_SUITE_P(
    Beside, Turns,
    testing::Values(
        Turn{"Appointment.Visitor", "no, not three, four",
             "~correct Appointment Time=16:00"},
        Turn{"", "no, it is near, I mean Margaret Sim",
             "~correct Appointment Host=Margaret Sim"},
        Turn{"Appointment.Visitor", "I'm Anouk, Windmolen Energy",
             "~inform Appointment Visitor=Anouk"},
        Turn{"Taxi.Destination", "at six", "inform Taxi Time=18:00"},
        Turn{"Taxi.Time", "not Zorkville, book a taxi to Bedok",
             "correct Taxi Destination=Bedok"},
        Turn{"", "Bank, please?", "~request Facility Category=bank"},
        Turn{"", "four", ""},
        Turn{"", "What a big house this is! Where is the bank?",
             "request Facility Category=bank"}));

// Not everything that could be a value is one.
INSTANTIATE_TEST_SUITE_P(
    NoValues, Turns,
    testing::Values(
        // A verb, a word for nothing, a participle.
        Turn{"", "is there anywhere I could need", ""},
        Turn{"", "is there a way", ""}, Turn{"", "where is postponed", ""},
        // Beside what another sentence wants: a part of "Sky garden".
        Turn{"", "It was dark in the sky. Is there a bank?",
             "request Facility Category=bank"},
        // A name, which another topic would take, in the same clause.
        Turn{"", "book a taxi Jeffery Ho", "inform Taxi"},
        Turn{"", "book a taxi, Jeffery Ho",
             "inform Taxi + ~inform Appointment Host=Jeffery Ho"}));

// A number that the asked slot cannot take is said of that slot.
INSTANTIATE_TEST_SUITE_P(
    WrongNumbers, Turns,
    testing::Values(
        Turn{"Taxi.Phone", "12", "~inform Taxi Phone=12?"},
        Turn{"Taxi.Phone", "my number is 12", "~inform Taxi Phone=12?"},
        Turn{"Taxi.Time", "at 25:00", "~inform Taxi Time=25:00?"},
        Turn{"Taxi.Time", "9123 4567", "~inform Taxi Phone=91234567"},
        Turn{"Taxi.Phone", "is there a bank on level 2",
             "request Facility Category=bank Location=2"},
        Turn{"", "25:00", ""}));

INSTANTIATE_TEST_SUITE_P(
    AskedFurther, Turns,
    testing::Values(Turn{"", "is there a bank and a toilet",
                         "request Facility Category=bank + "
                         "~request Facility Category=toilet"},
                    Turn{"", "is there a bank on level 2, on level 3",
                         "request Facility Category=bank Location=2 + "
                         "~request Facility Location=3"}));

// What is not understood before a value makes it another matter.
INSTANTIATE_TEST_SUITE_P(SomethingElse, Turns,
                         testing::Values(Turn{
                             "", "is there a bank and paint the blue toilet",
                             "request Facility Category=bank"}));

INSTANTIATE_TEST_SUITE_P(
    Elliptical, Turns,
    testing::Values(
        Turn{"Facility", "and a bank?", "~request Facility Category=bank"},
        Turn{"Facility", "on the first floor", "~request Facility Location=1"},
        Turn{"Facility", "what about the coffee shops",
             "~request Facility Category=coffee shop"},
        Turn{"", "Starbucks", "~request Facility Name=Starbucks Coffee"}));

INSTANTIATE_TEST_SUITE_P(
    Answers, Turns,
    testing::Values(
        Turn{"Appointment.Visitor", "David",
             "~inform Appointment Visitor=David"},
        Turn{"Appointment.Visitor", "it's David from Comptec",
             "inform Appointment Visitor=David Organisation=Comptec"},
        Turn{"Appointment.Visitor", "is there a bank",
             "request Facility Category=bank"},
        Turn{"Appointment.Time", "at three", "~inform Appointment Time=15:00"},
        Turn{"Appointment.Time", "four", "~inform Appointment Time=16:00"},
        Turn{"Appointment.Host", "Hui Min",
             "~inform Appointment Host=Ho Hui Min|Tan Hui Min"},
        Turn{"Taxi.Destination", "block 71 Ayer Rajah Crescent",
             "~inform Taxi Destination=block 71 Ayer Rajah Crescent"},
        Turn{"Taxi.Phone", "it's nine one two three four five six seven",
             "~inform Taxi Phone=91234567"}));

INSTANTIATE_TEST_SUITE_P(
    Names, Turns,
    testing::Values(
        Turn{"", "to meet Ho Jeffery", "inform Appointment Host=Jeffery Ho"},
        Turn{"", "to see Jeffrey Ho", "inform Appointment Host=Jeffery Ho"},
        Turn{"", "to meet Professor Sim",
             "inform Appointment Host=Margaret Sim"},
        Turn{"", "to meet Ms Tan",
             "inform Appointment Host=Tan Wei Ming|Tan Hui Min"},
        Turn{"", "to meet Tan Weiming", "inform Appointment Host=Tan Wei Ming"},
        Turn{"", "to meet Sumathi Arumugam",
             "inform Appointment Host=Sumathi d/o Arumugam"},
        Turn{"", "to meet Dr. Zzyzx Qwert",
             "inform Appointment Host=Zzyzx Qwert?"},
        Turn{"", "to meet Jeffery Smith",
             "inform Appointment Host=Jeffery Smith?"},
        Turn{"", "is there a helipad", "request Facility Category=helipad?"}));

INSTANTIATE_TEST_SUITE_P(
    Corrections, Turns,
    testing::Values(Turn{"Facility", "no, the sky garden",
                         "~correct Facility Name=Sky garden"},
                    Turn{"", "to meet Priya Nair at three, no sorry, four",
                         "inform Appointment Host=Priya Nair Time=16:00"},
                    Turn{"Appointment.Time", "not three, four",
                         "~correct Appointment Time=16:00"},
                    Turn{"Appointment.Time", "no, I meant half past ten",
                         "~correct Appointment Time=10:30"},
                    Turn{"Appointment", "no, to meet Anand",
                         "correct Appointment Host=Anand Menon"},
                    Turn{"Appointment", "no, is there a bank",
                         "deny + request Facility Category=bank"}));

INSTANTIATE_TEST_SUITE_P(
    Generic, Turns,
    testing::Values(
        Turn{"", "yes", "confirm"}, Turn{"", "Yes, please!", "confirm"},
        Turn{"", "no thanks", "deny"}, Turn{"", "help me please", "help"},
        Turn{"", "pardon?", "repeat"}, Turn{"", "never mind", "cancel"},
        Turn{"", "let's start over", "restart"},
        Turn{"", "good morning", "greet"},
        Turn{"", "thank you very much", "thank"}, Turn{"", "bye bye", "bye"},
        Turn{"", "thanks, goodbye", "bye"}));

INSTANTIATE_TEST_SUITE_P(
    SeveralActs, Turns,
    testing::Values(
        Turn{"", "I'm here to meet Jeffery Ho, and is there a food court?",
             "inform Appointment Host=Jeffery Ho + request Facility "
             "Category=food court"},
        Turn{"Appointment.Time", "yes, at ten",
             "~inform Appointment Time=10:00"},
        Turn{
            "", "is there a bank and is there a toilet on level 3",
            "request Facility Category=bank + request Facility Category=toilet "
            "Location=3"}));

INSTANTIATE_TEST_SUITE_P(
    Nothing, Turns,
    testing::Values(
        Turn{"", "", ""}, Turn{"", " .,;!? ", ""}, Turn{"", "blub blab", ""},
        Turn{"", "\xff\xfe\xc3\x28", ""},
        Turn{"", "qwerty uiop asdf ghjk on the second floor zxcv bnm lkjh poiu",
             ""}));

// Words within a text that is to be kept as it is mean nothing else.
TEST(NluEngine, TakesTheRestAsItWasSaid) {
  auto model = sample_model();
  model.grammars.push_back(
      {"notes",
       "public <note> = remind me to @rest {Destination} [at @time {Time}] "
       "{topic=Taxi};",
       {}});
  const auto built = NluEngine::build(model, sample_column, {});
  ASSERT_TRUE(built);
  const auto said = [&](const char* text) {
    return summary(built->understand(text).acts);
  };
  EXPECT_EQ(said("remind me to book a taxi to Bedok"),
            "inform Taxi Destination=book a taxi to Bedok");
  EXPECT_EQ(said("remind me to meet Jeffery Ho at ten, please"),
            "inform Taxi Destination=meet Jeffery Ho Time=10:00");
  EXPECT_EQ(said("is there a bank"), "request Facility Category=bank");
}

TEST(NluEngine, LeavesTheTopicOpenWhereOnlyTheSlotIsClear) {
  EXPECT_EQ(understood({"", "10:30", ""}), "~inform Time=10:30");
}

TEST(NluEngine, AsksForNothingMoreThanTheThreshold) {
  const auto strict = NluEngine::build(sample_model(), sample_column,
                                       {0.95, {generic_grammar()}});
  ASSERT_TRUE(strict);
  EXPECT_TRUE(strict->understand("well is there a bank zork").acts.empty());
  EXPECT_FALSE(strict->understand("well is there a bank").acts.empty());
}

// Two topics with slots of the same values, known by a few examples only.
std::string rented(const std::string& text) {
  const SlotModel kind{"Kind", "set", {"city bike", "tandem"}, "", true, false};
  UnderstandingModel model;
  model.topics = {
      {"Rent",
       false,
       {kind,
        {"Days", "number", {}, "", true, false},
        {"Start", "date", {}, "", true, false}},
       {"I would like to rent a [tandem](Kind)",
        "can I hire a [city bike](Kind) for [three](Days) days",
        "I need a bike from [tomorrow](Start)", "rent a bike"}},
      {"Price",
       true,
       {kind},
       {"how much is a [tandem](Kind)", "what does a [city bike](Kind) cost"}}};
  static const auto built =
      NluEngine::build(model, {}, {0.4, {generic_grammar()}});
  return summary(built->understand(text, sample_context("")).acts);
}

TEST(NluEngine, TellsTheTopicOfAValueByTheWordsAroundIt) {
  EXPECT_EQ(rented("rent a tandem"), "inform Rent Kind=tandem");
}

TEST(NluEngine, TakesNoStrangeWordForTheLikeliestTopic) {
  for (const auto* word : {"foo", "xyzzy", "pizza"})
    EXPECT_EQ(rented(word), "") << word;
}

TEST(NluEngine, TellsHowLongFromFromWhen) {
  EXPECT_THAT(rented("can I hire a city bike for three days from monday"),
              testing::AllOf(testing::HasSubstr("Days=3"),
                             testing::HasSubstr("Kind=city bike"),
                             testing::Not(testing::HasSubstr("-26"))));
}

TEST(NluEngine, BoundsItsWork) {
  static const auto engine = sample();
  for (const std::string word :
       {"is there ", "tan ho ", "no ", "1 2 3 ", "at three, ", "a", "\xff"}) {
    std::string text;
    while (text.size() < 100'000)
      text += word;
    const auto made = engine.understand(text, sample_context(""));
    EXPECT_LT(made.work, 2'000'000U) << word;
  }
}

TEST(NluEngine, WorksWithoutAnyGrammarOrValue) {
  UnderstandingModel model;
  model.topics = {{"Order", false, {{"Dish", "", {}, "", true, false}}, {}}};
  const auto built = NluEngine::build(model, {}, {0.4, {generic_grammar()}});
  ASSERT_TRUE(built);
  EXPECT_EQ(summary(built->understand("yes").acts), "confirm");
  EXPECT_EQ(
      summary(
          built->understand("nasi lemak", sample_context("Order.Dish")).acts),
      "~inform Order Dish=nasi lemak");
}

TEST(NluEngine, ReportsAllErrors) {
  auto model = sample_model();
  model.grammars = {{"g",
                     "public <a> = @Facilty.Name;\n"
                     "public <b> = <c>;\n"
                     "public <d> = x {Hots};",
                     {"g.jsgf", 10, 5}}};
  const auto built = NluEngine::build(model, sample_column, {});
  ASSERT_FALSE(built);
  ASSERT_EQ(built.error().size(), 3U);
  EXPECT_EQ(built.error()[0].message,
            "there is no topic 'Facilty', did you mean 'Facility'?");
  EXPECT_EQ(built.error()[1].place.line, 11U);
  EXPECT_EQ(built.error()[2].message,
            "no topic has a slot 'Hots', did you mean 'Host'?");
}

TEST(NluEngine, SaysWhy) {
  static const auto engine = sample();
  const auto made =
      engine.understand("is there a bank", sample_context(""), true);
  ASSERT_FALSE(made.explanation.empty());
  EXPECT_EQ(made.explanation[0], "tokens is there a bank(?)");
  EXPECT_GE(made.score, 0.9);
}

} // namespace
} // namespace parlour::adapters::nlu::test
