#include <gtest/gtest.h>

#include "adapters/nlu/acts/asides.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

constexpr TopicNumber facility = 1;
constexpr TopicNumber taxi = 2;

// "book a taxi", understood, and "the bank", a mere value.
std::vector<BuiltAct> acts() {
  BuiltAct sentence;
  sentence.act = "inform";
  sentence.topic = taxi;
  sentence.is_declared = true;
  sentence.end = 3;
  sentence.understood = sentence.score = 1;
  BuiltAct value;
  value.act = "request";
  value.topic = facility;
  value.elliptical = value.is_aside = true;
  value.begin = 3;
  value.end = 5;
  value.understood = value.score = 1;
  return {sentence, value};
}

std::size_t kept(std::vector<BuiltAct> acts,
                 const std::string& text = "book a taxi the bank",
                 const std::string& asked = "") {
  const Stages stages("public <x> = hello;", text, sample_context(asked));
  drop_asides(acts, stages.utterance, stages.context);
  return acts.size();
}

TEST(Asides, AreValuesInAClauseThatWantsSomethingElse) {
  EXPECT_EQ(kept(acts()), 1U);
  EXPECT_EQ(kept(acts(), "book a taxi, the bank"), 2U);
  EXPECT_EQ(kept(acts(), "book a taxi the bank", "Facility"), 2U);
  auto meant = acts();
  meant[1].is_aside = false;
  EXPECT_EQ(kept(meant), 2U);
  auto vague = acts();
  vague[0].is_declared = false;
  EXPECT_EQ(kept(vague), 2U);
}

TEST(Asides, AreRulesOfNothingButAValue) {
  const auto rule = [](std::uint32_t begin) {
    auto made = acts();
    made[1].is_aside = false;
    made[1].end = 6;
    Fill fill;
    fill.slot = "Name";
    fill.span = 0;
    fill.begin = begin;
    fill.end = 6;
    made[1].fills = {fill};
    return made;
  };
  EXPECT_EQ(kept(rule(5), "book a taxi at the bank"), 1U);
  EXPECT_EQ(kept(rule(5), "book a taxi, at the bank"), 2U);
  EXPECT_EQ(kept(rule(5), "book a taxi see the bank"), 2U);
  EXPECT_EQ(kept(rule(4), "book a taxi and the bank"), 2U);
  auto declared = rule(5);
  declared[1].is_declared = true;
  EXPECT_EQ(kept(declared, "book a taxi at the bank"), 2U);
}

TEST(Asides, AreValuesInAClauseAboutSomethingElse) {
  auto made = acts();
  made[1].begin = 4;
  made[1].end = 6;
  EXPECT_EQ(kept(made, "book a taxi, at the bank"), 2U);
  EXPECT_EQ(kept(made, "book a taxi, zork the bank"), 1U);
  // Also beside a mere value of what the conversation is about.
  made[0].is_declared = false;
  EXPECT_EQ(kept(made, "book a taxi, zork the bank"), 2U);
  EXPECT_EQ(kept(made, "book a taxi, zork the bank", "Taxi"), 1U);
}

TEST(Asides, AreFurtherValuesThatAreMostlyNotUnderstood) {
  auto further = acts();
  further[0].topic = facility;
  EXPECT_EQ(kept(further), 2U);
  further[1].understood = 0.5;
  EXPECT_EQ(kept(further), 1U);
  further[1].act = "correct";
  EXPECT_EQ(kept(further), 2U);
}

} // namespace
} // namespace parlour::adapters::nlu::test
