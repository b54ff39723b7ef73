#include <gmock/gmock.h>

#include "adapters/nlu/understand/sentences_apart.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

// The sentences' texts, each with how many acts it says, and a question mark.
std::vector<std::string> apart(const char* text,
                               const std::vector<TokenRange>& understood = {}) {
  const Automaton automaton;
  std::vector<BuiltAct> acts;
  for (const auto range : understood) {
    acts.emplace_back();
    acts.back().begin = range.begin;
    acts.back().end = range.end;
  }
  const auto utterance = make_utterance(text, automaton);
  std::vector<std::string> made;
  for (const auto& one : sentences_apart(utterance, acts))
    made.push_back(std::string(one.text) + " " +
                   std::to_string(one.acts.size()) +
                   (one.is_question ? "?" : ""));
  return made;
}

TEST(SentencesApart, HaveTheirActs) {
  constexpr auto text = "Zork, please. Where is the bank? My dog waits.";
  EXPECT_THAT(
      apart(text, {{0, 1}}),
      ElementsAre("Zork, please 1", "Where is the bank 0?", "My dog waits 0"));
  EXPECT_THAT(
      apart(text, {{0, 1}, {5, 6}, {3, 4}}),
      ElementsAre("Zork, please 1", "Where is the bank 2?", "My dog waits 0"));
}

TEST(SentencesApart, ShareNoAct) {
  constexpr auto text = "Zork, please. Where is the bank? My dog waits.";
  EXPECT_THAT(apart(text, {{0, 3}}), ElementsAre("My dog waits 0"));
  EXPECT_THAT(apart(text, {{0, 9}}), IsEmpty());
}

TEST(SentencesApart, AreNotTheWholeUtterance) {
  EXPECT_THAT(apart("Where is the bank?"), IsEmpty());
  EXPECT_THAT(apart("Where is the bank, and my dog"), IsEmpty());
  EXPECT_THAT(apart(""), IsEmpty());
}

TEST(SentencesApart, HaveAWordOfTheirOwn) {
  EXPECT_THAT(apart("Where is the bank? And that is it."),
              ElementsAre("Where is the bank 0?"));
}

TEST(SentencesApart, AreQuestionsAlsoWithoutAMark) {
  EXPECT_THAT(apart("Zork. Could my dog swim. The dog swims? Dog?"),
              ElementsAre("Zork 0", "Could my dog swim 0?", "The dog swims 0?",
                          "Dog 0"));
  EXPECT_THAT(
      apart("Zork. Do you zork them. Do not zork them."),
      ElementsAre("Zork 0", "Do you zork them 0?", "Do not zork them 0"));
}

Value act_of(const char* topic, double confidence, Map slots,
             bool elliptical = false) {
  return Value(Map{{act_key::topic, topic},
                   {act_key::confidence, confidence},
                   {act_key::slots, Value(std::move(slots))},
                   {act_key::elliptical, elliptical}});
}

TEST(SentencesApart, AreSaidAloneWhereNothingElseIs) {
  EXPECT_TRUE(is_said_alone(act_of("Bank", 0.6, {}), {}));
  EXPECT_FALSE(is_said_alone(act_of("Bank", 0.5, {}), {}));
  EXPECT_FALSE(is_said_alone(Value(Map{{act_key::confidence, 1.0}}), {}));
}

TEST(SentencesApart, AreSaidBesideWhatWasLearntIfTheySayMore) {
  const List learnt{act_of("Told", 0.7, {})};
  const Map number{{"Number", 4733}};
  EXPECT_TRUE(is_said_alone(act_of("Booking", 1, number), learnt));
  EXPECT_TRUE(is_said_alone(act_of("Told", 1, number), learnt));
  EXPECT_FALSE(is_said_alone(act_of("Told", 1, number),
                             {act_of("Told", 0.7, {{"Kind", "suite"}})}));
  EXPECT_FALSE(is_said_alone(act_of("Booking", 0.8, number), learnt));
  EXPECT_FALSE(is_said_alone(act_of("Booking", 1, {}), learnt));
  EXPECT_FALSE(is_said_alone(act_of("Booking", 1, number, true), learnt));
}

TEST(SentencesApart, StandBeforeWhatWasLearntAndInItsPlace) {
  const auto booking = act_of("Booking", 1, {{"Number", 4733}});
  const auto told = act_of("Told", 0.7, {});
  List acts{told};
  put_before({booking}, acts);
  EXPECT_EQ(acts, (List{booking, told}));
  const auto more = act_of("Told", 1, {{"Number", 4733}});
  put_before({more}, acts);
  EXPECT_EQ(acts, (List{more, booking}));
  put_before({}, acts);
  EXPECT_EQ(acts, (List{more, booking}));
}

} // namespace
} // namespace parlour::adapters::nlu::test
