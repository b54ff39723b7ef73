#include <gtest/gtest.h>

#include "script/dialogue/acts/acts.hpp"

namespace parlour::dialogue {

namespace {

Value one(Map map) {
  return List{std::move(map)};
}

TEST(Acts, AreReadFromAFrameList) {
  auto parsed =
      parse_acts(one({{"topic", "Appointment"},
                      {"act", "inform"},
                      {"confidence", 0.8},
                      {"text", "I am David"},
                      {"elliptical", true},
                      {"slots", Map{{"Visitor", "David"},
                                    {"Host", Map{{"value", "Jeffery Ho"},
                                                 {"confidence", 0.6},
                                                 {"text", "jefry ho"}}}}}}));
  ASSERT_EQ(parsed.acts.size(), 1u);
  EXPECT_TRUE(parsed.problems.empty());
  const auto& act = parsed.acts[0];
  EXPECT_EQ(act.kind, ActKind::inform);
  EXPECT_EQ(act.topic, "Appointment");
  EXPECT_EQ(act.confidence, Value(0.8));
  EXPECT_EQ(act.text, "I am David");
  EXPECT_TRUE(act.elliptical);
  ASSERT_EQ(act.slots.size(), 2u);
  EXPECT_EQ(act.slots[0].value, Value("David"));
  EXPECT_TRUE(act.slots[0].confidence.is_unknown());
  EXPECT_EQ(act.slots[1].value, Value("Jeffery Ho"));
  EXPECT_EQ(act.slots[1].confidence, Value(0.6));
  EXPECT_EQ(act.slots[1].text, "jefry ho");
}

TEST(Acts, MayComeAsOneMapOrAListInAList) {
  EXPECT_EQ(parse_acts(Map{{"act", "help"}}).acts.size(), 1u);
  auto nested = parse_acts(
      List{Value(List{Map{{"act", "greet"}}, Map{{"act", "request"}}})});
  ASSERT_EQ(nested.acts.size(), 2u);
  EXPECT_EQ(nested.acts[0].kind, ActKind::greet);
  EXPECT_EQ(nested.acts[1].kind, ActKind::request);
}

TEST(Acts, KnowEveryKindByItsName) {
  for (const auto* name :
       {"inform",  "request", "confirm", "deny",    "correct",
        "help",    "repeat",  "cancel",  "restart", "greet",
        "bye",     "thank",   "explain", "options", "rephrase",
        "abandon", "person",  "wait",    "protest", "refuse"}) {
    auto parsed = parse_acts(one({{"act", name}}));
    ASSERT_EQ(parsed.acts.size(), 1u) << name;
    EXPECT_EQ(name_of(parsed.acts[0].kind), name);
  }
}

TEST(Acts, WithoutNameInform) {
  auto parsed = parse_acts(one({{"topic", "Taxi"}}));
  ASSERT_EQ(parsed.acts.size(), 1u);
  EXPECT_EQ(parsed.acts[0].kind, ActKind::inform);
}

TEST(Acts, HoldCandidatesAndWordsThatMatchNothing) {
  auto parsed = parse_acts(
      one({{"slots",
            Map{{"Host", Map{{"candidates", List{"A Tan", "B Tan"}}}},
                {"Room", Map{{"text", "the moon"}, {"unmatched", true}}}}}}));
  ASSERT_EQ(parsed.acts.size(), 1u);
  EXPECT_EQ(parsed.acts[0].slots[0].candidates, (List{"A Tan", "B Tan"}));
  EXPECT_TRUE(parsed.acts[0].slots[1].unmatched);
  EXPECT_TRUE(parsed.problems.empty());
}

TEST(Acts, AlternativesAreTheFirstActsOnly) {
  Map other{{"topic", "Taxi"}, {"confidence", 0.5}};
  auto parsed = parse_acts(
      List{Map{{"topic", "Facility"}, {"alternatives", List{other, "no map"}}},
           Map{{"topic", "Facility"}, {"alternatives", List{other}}}});
  ASSERT_EQ(parsed.acts.size(), 2u);
  ASSERT_EQ(parsed.acts[0].alternatives.size(), 1u);
  EXPECT_EQ(parsed.acts[0].alternatives[0].topic, "Taxi");
  EXPECT_TRUE(parsed.acts[1].alternatives.empty());
  EXPECT_EQ(parsed.problems.size(), 1u);
}

struct Nonsense {
  const char* name;
  Value frames;
  std::size_t acts;
  std::size_t problems;
};

class ActsOfNonsense : public testing::TestWithParam<Nonsense> {};

TEST_P(ActsOfNonsense, AreLeftOutAndCounted) {
  auto parsed = parse_acts(GetParam().frames);
  EXPECT_EQ(parsed.acts.size(), GetParam().acts);
  EXPECT_EQ(parsed.problems.size(), GetParam().problems);
}

INSTANTIATE_TEST_SUITE_P(
    All, ActsOfNonsense,
    testing::Values(
        Nonsense{"unknown", Value(), 0, 1}, Nonsense{"text", "hello", 0, 1},
        Nonsense{"empty_list", List{}, 0, 0},
        Nonsense{"numbers", List{1, 2.5}, 0, 2},
        Nonsense{"unknown_act", one({{"act", "sing"}}), 0, 1},
        Nonsense{"act_number", one({{"act", 3}}), 0, 1},
        Nonsense{"topic_number", one({{"topic", 3}}), 0, 1},
        Nonsense{"confidence_text", one({{"confidence", "high"}}), 1, 1},
        Nonsense{"confidence_outside", one({{"confidence", 1.5}}), 1, 1},
        Nonsense{"slots_text", one({{"slots", "Time"}}), 1, 1},
        Nonsense{"slot_unknown", one({{"slots", Map{{"A", Value()}}}}), 1, 1},
        Nonsense{"slot_result", one({{"slots", Map{{"A", ResultSet{}}}}}), 1,
                 2},
        Nonsense{"candidates_text",
                 one({{"slots", Map{{"A", Map{{"candidates", "x"}}}}}}), 1, 2},
        Nonsense{"elliptical_text", one({{"elliptical", "yes"}}), 1, 1},
        Nonsense{"alternatives_text", one({{"alternatives", "x"}}), 1, 1},
        Nonsense{"too_deep", List{Value(List{Value(List{Value(List{Map{}})})})},
                 0, 1}),
    [](const auto& test) { return test.param.name; });

TEST(Acts, AreTheSameAfterAWayThroughAValue) {
  Act act;
  act.kind = ActKind::correct;
  act.topic = "Taxi";
  act.confidence = 0.7;
  act.text = "no, four";
  act.elliptical = true;
  SlotValue time;
  time.slot = "Time";
  time.value = "16:00";
  time.confidence = 0.9;
  time.text = "four";
  SlotValue place;
  place.slot = "Destination";
  place.candidates = {"A", "B"};
  place.text = "that place";
  place.unmatched = true;
  time.heard = true;
  act.slots = {time, place};
  act.alternatives.resize(1);
  auto parsed = parse_acts(to_value(act));
  ASSERT_EQ(parsed.acts.size(), 1u);
  EXPECT_TRUE(parsed.problems.empty());
  EXPECT_EQ(to_value(parsed.acts[0]), to_value(act));
  EXPECT_EQ(parsed.acts[0].slots[1].candidates, place.candidates);
  EXPECT_TRUE(parsed.acts[0].slots[1].unmatched);
  EXPECT_TRUE(parsed.acts[0].slots[0].heard);
  EXPECT_FALSE(parsed.acts[0].slots[1].heard);
}

} // namespace

TEST(Acts, MayNameASlot) {
  Act act;
  act.kind = ActKind::correct;
  act.slots.resize(1);
  act.slots[0].slot = "Day";
  act.slots[0].text = "the day";
  EXPECT_FALSE(names_slot(act));
  act.slots[0].unmatched = true;
  EXPECT_TRUE(names_slot(act));
  act.slots[0].value = "Monday";
  EXPECT_FALSE(names_slot(act));
}

TEST(Acts, ThatCancelAreAboutTheConversation) {
  Act act;
  act.slots.resize(1);
  for (const auto kind : {ActKind::cancel, ActKind::abandon}) {
    act.kind = kind;
    EXPECT_TRUE(is_generic(act)) << name_of(kind);
  }
  act.kind = ActKind::help;
  EXPECT_FALSE(is_generic(act));
}

} // namespace parlour::dialogue
