// Stages: the stages of understanding one utterance, so that a test can look at
// each of them. It uses the sample's topics and values and the test's grammar.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "adapters/nlu/acts/acts.hpp"
#include "adapters/nlu/grammar/automaton_builder.hpp"
#include "tests/adapters/nlu/sample.hpp"

namespace parlour::adapters::nlu::test {

// Neither copied nor moved, because its members refer to each other.
class Stages {
public:
  // `generic`: as if the grammar were the platform's.
  Stages(const std::string& grammar, std::string said, const Value& where = {},
         bool generic = false)
      : text(std::move(said)), schema(sample_model(), sample_column, errors_),
        automaton(build(grammar, generic)),
        context(read_context(where, schema)),
        utterance(make_utterance(text, automaton)),
        spans(schema, utterance, entities(), context.now),
        matcher(automaton, utterance, spans, context.asked_entity_id,
                context.grammar),
        matches(matcher.run()),
        islands(read_islands(matches, matcher.traces(), spans, automaton,
                             schema, context)) {}
  Stages(const Stages&) = delete;
  Stages& operator=(const Stages&) = delete;

  std::string words(std::size_t begin, std::size_t end) const {
    return std::string(words_of(text, utterance.tokens, begin, end));
  }

  EntityId entity(const std::string& reference) {
    return schema.resolve(reference, {}, errors_)->entity;
  }

private:
  std::vector<Error> errors_; // declared before the members that report to it

  Automaton build(const std::string& grammar, bool generic) {
    AutomatonBuilder builder(schema, errors_);
    RuleInfo info;
    info.grammar = "g";
    info.generic = generic;
    builder.add(jsgf::parse({"g", grammar, {}}, errors_), info);
    auto made = builder.finish();
    for (const auto& error : errors_)
      ADD_FAILURE() << to_string(error);
    return made;
  }

  std::vector<EntityId> entities() const {
    auto all = automaton.entities;
    all.push_back(context.asked_entity_id);
    std::ranges::sort(all);
    return all;
  }

public:
  const std::string text;
  Schema schema;
  const Automaton automaton;
  const Context context;
  const Utterance utterance;
  Spans spans;
  Matcher matcher;
  const std::vector<Match> matches;
  const std::vector<Island> islands;
};

} // namespace parlour::adapters::nlu::test
