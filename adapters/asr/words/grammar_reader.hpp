// Puts the rules of JSGF grammars into a word graph. References to values
// become symbols of their sets (value_sets.hpp); weights and tags say nothing
// about what is heard. Rules that refer to themselves and rules that are
// missing are left out: the understanding has reported them.
#pragma once

#include <string>
#include <vector>

#include "adapters/asr/words/value_sets.hpp"
#include "adapters/asr/words/word_graph.hpp"
#include "adapters/nlu/grammar/jsgf.hpp"

namespace parlour::adapters::asr {

// A rule is copied wherever it is referred to; only value sets are shared.
class GrammarReader {
public:
  // All must outlive this.
  GrammarReader(Symbols& symbols, ValueSets& sets, Spellings& spellings)
      : symbols_(symbols), sets_(sets), spellings_(spellings) {}

  // Adds each public rule as a sentence.
  // `grammar` has to live during the call only.
  void add(const nlu::jsgf::Grammar& grammar, GraphBuilder& to);
  // Adds a node that belongs to no grammar, such as an example.
  void add(const nlu::jsgf::Node& node, GraphBuilder& to);
  // Each public rule is the form of its name: <time>. Here, "am" is not that of
  // "I am".
  void add_forms(const nlu::jsgf::Grammar& grammar);

private:
  using State = GraphBuilder::State;
  using Node = nlu::jsgf::Node;

  // Each adds the node's words from this state on and returns where they end.
  State build(const Node& node, State from);
  State build_determiner(State from);
  State build_word(const Node& node, State from);
  State build_rule(const Node& node, State from);
  State build_reference(const Node& node, State from);
  State build_alternatives(const Node& node, State from);
  State build_repeat(const Node& node, State from, bool may_be_none);

  Symbols& symbols_;
  ValueSets& sets_;
  Spellings& spellings_;
  GraphBuilder* to_ = nullptr;
  const nlu::jsgf::Grammar* grammar_ = nullptr;
  // Whether the words belong to a form such as <time>.
  bool is_form_ = false;
  // The rules that are being copied.
  std::vector<const nlu::jsgf::Rule*> inside_;
  // The slot that the words fill that are being added.
  std::vector<std::string> slots_;
};

} // namespace parlour::adapters::asr
