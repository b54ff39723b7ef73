#include <gmock/gmock.h>

#include "adapters/nlu/grammar/merged_states.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAreArray;

// Each with its words, its score and what it says.
std::vector<std::string> islands_of(Stages& stages,
                                    const Automaton& automaton) {
  const auto utterance = make_utterance(stages.text, automaton);
  Spans spans(stages.schema, utterance, automaton.entities, {});
  Matcher matcher(automaton, utterance, spans, asked_entity);
  std::vector<std::string> lines;
  for (const auto& island :
       read_islands(matcher.run(), matcher.traces(), spans, automaton,
                    stages.schema, stages.context)) {
    auto line = stages.words(island.begin, island.end) + " " +
                island.rule->name + " " + island.act + " " +
                std::to_string(island.score);
    for (const auto& fill : island.fills)
      line += " " + fill.slot + "=" + stages.words(fill.begin, fill.end) +
              (fill.literal ? to_string(*fill.literal) : "");
    lines.push_back(line);
  }
  return lines;
}

void expect_the_same(const std::string& grammar, const std::string& said) {
  Stages stages(grammar, said);
  const auto before = islands_of(stages, stages.automaton);
  EXPECT_THAT(before, Not(IsEmpty())) << said;
  EXPECT_THAT(islands_of(stages, merge_states(stages.automaton)),
              UnorderedElementsAreArray(before))
      << said;
}

constexpr auto cabs = R"(
public <cab> = [please] (call | order) (me | us) a cab {act=request} {topic=Taxi};
public <stop> = [please] (call | order) (me | us) no cab {act=cancel};
public <when> = call me a cab at @time {Time} {topic=Taxi} {act=inform};
public <loop> = (call me)+ [again] {act=repeat};
)";

TEST(MergedStates, say_what_the_rules_said) {
  for (const auto* said :
       {"call me a cab", "please order us no cab", "call me a cab at ten",
        "call me call me call me again", "call er me a red cab at half six",
        "so call me"})
    expect_the_same(cabs, said);
}

TEST(MergedStates, are_one_where_rules_begin_alike) {
  Stages stages(cabs, "");
  const auto merged = merge_states(stages.automaton);
  const auto call = stages.automaton.word("call");
  EXPECT_THAT(arcs_of(stages.automaton.states[0].words, call), SizeIs(4));
  EXPECT_THAT(arcs_of(merged.states[0].words, call), SizeIs(1));
  EXPECT_LT(merged.states.size(), stages.automaton.states.size());
}

TEST(MergedStates, stay_apart_where_a_slot_begins) {
  Stages stages("public <a> = one {Phone=1} cab; public <b> = one car;", "");
  const auto merged = merge_states(stages.automaton);
  EXPECT_THAT(arcs_of(merged.states[0].words, merged.word("one")), SizeIs(2));
}

TEST(MergedStates, of_no_rules_are_none) {
  EXPECT_THAT(merge_states({}).states, IsEmpty());
}

// Of three words out of many a set for each choice might be made.
TEST(MergedStates, do_not_grow_without_bound) {
  std::string grammar;
  for (int rule = 0; rule < 12; ++rule)
    grammar += "public <r" + std::to_string(rule) + "> = (a | b)* a" + [rule] {
      std::string rest;
      for (int at = 0; at < rule; ++at)
        rest += " (a | b)";
      return rest;
    }() + " end;";
  Stages stages(grammar, "a b a b b a end");
  const auto merged = merge_states(stages.automaton);
  EXPECT_LE(merged.states.size(), 3 * stages.automaton.states.size());
  EXPECT_THAT(islands_of(stages, merged),
              UnorderedElementsAreArray(islands_of(stages, stages.automaton)));
}

} // namespace
} // namespace parlour::adapters::nlu::test
