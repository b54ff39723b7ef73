#include "script/dialogue/frame/matching.hpp"
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

class Matching : public testing::Test {
protected:
  CodeId value(Value value) {
    values_.push_back(std::move(value));
    return static_cast<CodeId>(values_.size() - 1);
  }
  CardinalityEvaluator evaluator() const {
    return [this](CodeId code) -> Expected<Value> { return values_.at(code); };
  }
  void set_of(const List& values) {
    slot.cardinality.type = "set";
    for (const auto& one : values)
      slot.cardinality.values.push_back(value(one));
  }
  Matched said(Value what) const {
    return match(slot, fill(0, std::move(what)), evaluator());
  }

  script::Slot slot;

private:
  List values_;
};

TEST_F(Matching, ASetGivesItsCanonicalValue) {
  set_of({"Swimming pool", "Sky garden", "Auditorium", "Star home"});
  const std::vector<std::pair<const char*, const char*>> cases{
      {"Sky garden", "Sky garden"},        {"SKY  GARDEN", "Sky garden"},
      {"garden sky", "Sky garden"},        {"swiming pool", "Swimming pool"},
      {"swimming pools", "Swimming pool"}, {"starhome", "Star home"},
      {"auditorum", "Auditorium"}};
  for (const auto& [words, expected] : cases)
    EXPECT_EQ(said(words).value, Value(expected)) << words;
  for (const auto* words : {"library", "sky", "", "pool garden"})
    EXPECT_FALSE(said(words)) << words;
}

TEST_F(Matching, OfEquallyNearValuesAllAreCandidates) {
  set_of({"Meeting roon", "Meeting roomy", "Kitchen"});
  auto matched = said("meeting roomn");
  EXPECT_TRUE(matched.value.is_unknown());
  EXPECT_EQ(matched.candidates, (List{"Meeting roon", "Meeting roomy"}));
}

TEST_F(Matching, ANearerValueWins) {
  set_of({"Marina", "Marine"});
  EXPECT_EQ(said("marine").value, Value("Marine"));
}

TEST_F(Matching, ASetMayComeFromAnExpression) {
  set_of({List{"small", "large"}, 3});
  EXPECT_EQ(said("Large").value, Value("large"));
  EXPECT_EQ(said("3").value, Value(3));
}

TEST_F(Matching, WordsStandWhereAValueIsMissing) {
  set_of({"Sky garden"});
  FrameChange change = fill(0, {});
  change.text = "sky gardn";
  change.unmatched = true;
  EXPECT_EQ(match(slot, change, evaluator()).value, Value("Sky garden"));
}

struct RangeCase {
  Value low, high, said, expected;
};

TEST_F(Matching, ARangeHasBounds) {
  const std::vector<RangeCase> cases{
      {1, 10, 5, 5},
      {1, 10, "10", 10},
      {1, 10, 11, {}},
      {1, 10, 0, {}},
      {1, {}, 99, 99},
      {{}, 10, -5, -5},
      {1, 10, "many", {}},
      {0.5, 1.5, 1, 1},
      {"1", "10", 9, 9},
      {"09:00", "17:30", "10:30am", "10:30"},
      {"9:00", "17:30", "8:59", {}},
      {"09:00", "17:30", "17:30", "17:30"},
      {"2026-01-01", "2026-12-31", "21/11/2026", "2026-11-21"},
      {"2026-01-01", {}, "2025-12-31", {}},
      {"09:00", 10, "09:30", {}}};
  for (const auto& one : cases) {
    slot.cardinality = {};
    slot.cardinality.type = "range";
    if (!one.low.is_unknown())
      slot.cardinality.minimum = value(one.low);
    if (!one.high.is_unknown())
      slot.cardinality.maximum = value(one.high);
    EXPECT_EQ(said(one.said).value, one.expected) << to_string(one.said);
  }
}

TEST_F(Matching, APatternMatchesTheWhole) {
  slot.cardinality.type = "pattern";
  slot.cardinality.pattern = "[A-Z]{3}[0-9]{1,4}";
  EXPECT_EQ(said("SBA123").value, Value("SBA123"));
  EXPECT_FALSE(said("x SBA123"));
  EXPECT_FALSE(said("sba123"));
  slot.cardinality.pattern = "(";
  EXPECT_FALSE(said("("));
}

TEST_F(Matching, TypedValuesComeInNormalForm) {
  slot.cardinality.type = "time";
  EXPECT_EQ(said("10:30am").value, Value("10:30"));
  EXPECT_FALSE(said("noonish"));
}

TEST_F(Matching, AQueryTrustsTheUnderstanding) {
  slot.cardinality.type = "query";
  EXPECT_EQ(said("Dr. Jeffery Ho").value, Value("Dr. Jeffery Ho"));
  auto stranger = fill(0, "Mr. Nobody");
  stranger.unmatched = true;
  EXPECT_FALSE(match(slot, stranger, evaluator()));
  auto words = fill(0, {});
  words.text = "mister nobody";
  words.unmatched = true;
  EXPECT_FALSE(match(slot, words, evaluator()));
}

TEST_F(Matching, CandidatesAreMatchedOneByOne) {
  slot.cardinality.type = "query";
  auto change = fill(0, {});
  change.candidates = {"Tan Ah Kow", "Tan Bee Hoon"};
  EXPECT_EQ(match(slot, change, evaluator()).candidates, change.candidates);
  change.candidates = {"Tan Ah Kow", "Tan Ah Kow"};
  EXPECT_EQ(match(slot, change, evaluator()).value, Value("Tan Ah Kow"));
  slot.cardinality.type = "level";
  change.candidates = {"B1", "nonsense"};
  EXPECT_EQ(match(slot, change, evaluator()).value, Value(-1));
}

TEST_F(Matching, WithoutCardinalityAnythingGoesButNothing) {
  EXPECT_EQ(said("David").value, Value("David"));
  EXPECT_EQ(said(0).value, Value(0));
  EXPECT_EQ(said(false).value, Value(false));
  EXPECT_FALSE(said(""));
  EXPECT_FALSE(said("  "));
  EXPECT_FALSE(said({}));
}

TEST_F(Matching, AChoiceIsNarrowedDown) {
  slot.cardinality.type = "query";
  const List choices{"Tan Ah Kow", "Tan Bee Hoon", "Lim Bee Hoon"};
  auto pick = [&](FrameChange change) {
    return match_choice(slot, change, choices, evaluator());
  };
  auto words = fill(0, {});
  words.text = "Ah Kow";
  words.unmatched = true;
  EXPECT_EQ(pick(words).value, Value("Tan Ah Kow"));
  words.text = "bee hoon";
  EXPECT_EQ(pick(words).candidates, (List{"Tan Bee Hoon", "Lim Bee Hoon"}));
  words.text = "nobody of these";
  EXPECT_FALSE(pick(words));
  EXPECT_EQ(pick(fill(0, "Lim Bee Hoon")).value, Value("Lim Bee Hoon"));
  EXPECT_EQ(pick(fill(0, "Ong Siew Lan")).value, Value("Ong Siew Lan"));
  auto both = fill(0, {});
  both.candidates = {"Lim Bee Hoon", "Lim Ah Seng"};
  EXPECT_EQ(pick(both).value, Value("Lim Bee Hoon"));
}

} // namespace

} // namespace parlour::dialogue
