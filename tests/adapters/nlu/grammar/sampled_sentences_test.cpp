#include <set>

#include <gmock/gmock.h>

#include "adapters/nlu/grammar/sampled_sentences.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

// Each as its words ("@" is a value) and what it means.
std::set<std::string> sampled(const std::string& rules,
                              std::size_t count = 200) {
  Stages stages(rules, "");
  std::set<std::string> made;
  for (const auto& one :
       sample_sentences(stages.automaton, stages.schema, count)) {
    std::string line;
    for (const auto& word : one.words)
      line += (word.starts_with('@') ? "@" : word) + " ";
    line += "-> " + one.meaning.act + " " +
            stages.schema.at(one.meaning.topic).name;
    for (const auto& [slot, value] : one.meaning.literals)
      line += " " + slot + "=" + value.text();
    for (const auto& [slot, entity] : one.values)
      line += " " + slot + "=@";
    made.insert(line);
  }
  return made;
}

TEST(ValueWord, TellsItsKind) {
  EXPECT_EQ(kind_of_word(value_word(12)), 12U);
  EXPECT_EQ(kind_of_word("twelve"), std::nullopt);
}

TEST(SampledSentences, AreAllThatRulesSay) {
  EXPECT_THAT(
      sampled("public <cab> = [please] (call | order) a cab {topic=Taxi};"),
      UnorderedElementsAre("call a cab -> inform Taxi",
                           "order a cab -> inform Taxi",
                           "please call a cab -> inform Taxi",
                           "please order a cab -> inform Taxi"));
}

// Else a word more in one rule would change what others are like.
TEST(SampledSentences, OfARuleDoNotHangOnOtherRules) {
  std::string rule = "public <cab> = ";
  for (int word = 0; word < 12; ++word)
    rule += "[w" + std::to_string(word) + "] ";
  rule += "{topic=Taxi};";
  const auto alone = sampled(rule, 600);
  auto left =
      sampled(rule + "public <shut> = is the bank shut {topic=Facility};", 600);
  EXPECT_EQ(left.erase("is the bank shut -> request Facility"), 1u);
  EXPECT_GT(left.size(), 100u);
  EXPECT_THAT(left, testing::IsSubsetOf(alone));
}

TEST(SampledSentences, HaveTheirMeaning) {
  EXPECT_THAT(sampled("public <shut> = is the bank shut {Location=2}"
                      " {Category=bank} {topic=Facility} {act=inform};"),
              ElementsAre("is the bank shut -> inform Facility Category=bank "
                          "Location=2"));
  // A slot that one topic has, and its usual act.
  EXPECT_THAT(sampled("public <where> = where is @Facility.Category;"),
              ElementsAre("where is @ -> request Facility Category=@"));
  EXPECT_THAT(sampled("public <host> = meet @db:staff.name {Host};"),
              ElementsAre("meet @ -> inform Appointment Host=@"));
}

TEST(SampledSentences, LeaveOutValuesThatAreAnyWords) {
  EXPECT_THAT(sampled("public <to> = drive to @words {Destination};"),
              ElementsAre("drive to -> inform Taxi"));
  // What is asked of nothing is no question.
  EXPECT_THAT(sampled("public <find> = find @words {Name} {topic=Facility};"),
              ElementsAre("find @ -> request Facility"));
}

TEST(SampledSentences, AreNoneWithoutATopicOfTheirOwn) {
  EXPECT_THAT(sampled("public <yes> = yes {act=confirm};"), IsEmpty());
  // Appointments and taxis have a time.
  EXPECT_THAT(sampled("public <at> = at @time {Time};"), IsEmpty());
  EXPECT_THAT(sampled("public <no> = not {denies=next} "
                      "@Facility.Category {topic=Facility};"),
              IsEmpty());
  EXPECT_THAT(sampled("public <it> = take @asked;"), IsEmpty());
}

TEST(SampledSentences, AreBounded) {
  const std::string long_rule =
      "public <many> = (a | b | c | d | e)+ cab {topic=Taxi};";
  const auto few = sampled(long_rule, 10);
  EXPECT_LE(few.size(), 10U);
  EXPECT_THAT(few, Not(IsEmpty()));
  EXPECT_EQ(few, sampled(long_rule, 10));
  EXPECT_THAT(sampled("public <never> = cab <VOID> {topic=Taxi};"), IsEmpty());
}

} // namespace
} // namespace parlour::adapters::nlu::test
