#include <gtest/gtest.h>

#include "adapters/nlu/understand/heard_texts.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {
namespace {

// What becomes of a text where these others may have been said.
List acts_of(const std::string& text, const List& others,
             const std::string& asked = "") {
  static const auto engine = sample();
  auto context = *sample_context(asked).if_map();
  context.set("heard", others);
  return engine.understand(text, context).acts;
}

std::string understood(const std::string& text, const List& others,
                       const std::string& asked = "") {
  return summary(acts_of(text, others, asked));
}

TEST(HeardTexts, AnotherIsTakenWhereItMakesSense) {
  EXPECT_EQ(understood("is there a bunk on level tool",
                       {"is there a bunk on level two",
                        "is there a bank on level two"}),
            "request Facility Category=bank Location=2");
  EXPECT_EQ(understood("to meat prayer near", {"to meet Priya Nair"}),
            "inform Appointment Host=Priya Nair");
}

TEST(HeardTexts, AnotherIsNeverCertain) {
  const auto acts = acts_of("to meat prayer near", {"to meet Priya Nair"});
  ASSERT_EQ(acts.size(), 1u);
  EXPECT_EQ(acts[0][act_key::confidence].number_or(1), 0.6);
  EXPECT_EQ(acts[0][act_key::slots]["Host"][act_key::confidence].number_or(1),
            0.6);
}

TEST(HeardTexts, WhatWasUnderstoodStands) {
  EXPECT_EQ(understood("is there a bank", {"is there a toilet on level two"}),
            "request Facility Category=bank");
  EXPECT_EQ(understood("at ten", {"at eleven"}, "Appointment.Time"),
            understood("at ten", {}, "Appointment.Time"));
}

// Neither is a yes, no or cancel made of something else, nor the other way
// round.
TEST(HeardTexts, ActsAboutTheConversationAreLeftAlone) {
  for (const auto* const act : {"yes", "no", "cancel that", "never mind"}) {
    EXPECT_EQ(understood("jest", {act}, "Taxi.Phone"),
              understood("jest", {}, "Taxi.Phone"));
    EXPECT_EQ(understood(act, {"is there a bank"}), understood(act, {}));
  }
}

TEST(HeardTexts, AnotherMustBeUnderstoodAsAWhole) {
  EXPECT_EQ(understood("he scored twice", {"he scored at two"}), "");
  EXPECT_EQ(understood("to meat prayer near", {"to meet prior nearly"}),
            understood("to meat prayer near", {}));
}

// Whoever was asked for a time and is not understood did not order a taxi.
TEST(HeardTexts, AnotherFitsWhatWasAsked) {
  const auto at = [](const char* asked) {
    return understood("at 25:00 on level tool", {"on level two"}, asked);
  };
  EXPECT_EQ(at("Taxi.Time").find("Facility"), std::string::npos);
}

TEST(HeardTexts, ANameThatOnlySoundsLikeOneIsDoubted) {
  const auto engine = NluEngine::build(sample_model(), sample_people, {});
  ASSERT_TRUE(engine);
  const auto host = [&](const char* text, const Value& context) {
    const auto acts = engine->understand(text, context).acts;
    return acts.empty() ? Value() : acts[0][act_key::slots]["Host"];
  };
  const Value heard = Map{{"heard", List{}}};
  const auto made = host("to see Koh Sok Hui", heard);
  EXPECT_EQ(made[act_key::value], Value("Koh Sok Hwee"));
  EXPECT_EQ(made[act_key::heard], Value(true));
  EXPECT_LT(made[act_key::confidence].number_or(1), 0.7);
  const auto typed = host("to see Koh Sok Hui", {});
  EXPECT_NE(typed[act_key::value], Value("Koh Sok Hwee"));
  const auto named = host("to see Jeffery Ho", heard);
  EXPECT_EQ(named[act_key::value], Value("Jeffery Ho"));
  EXPECT_TRUE(named[act_key::heard].is_unknown());
}

TEST(HeardTexts, AFewAreLookedAt) {
  List many;
  for (int i = 0; i < 50; ++i)
    many.push_back("text " + std::to_string(i));
  EXPECT_EQ(other_texts(Map{{"heard", many}}, "text 0").size(), 4u);
  EXPECT_EQ(other_texts(Map{{"heard", many}}, "text 0")[0], "text 1");
  EXPECT_TRUE(other_texts(Map{{"heard", List{7, "", Map{}}}}, "x").empty());
  EXPECT_TRUE(other_texts(Value(), "x").empty());
}

} // namespace
} // namespace parlour::adapters::nlu::test
