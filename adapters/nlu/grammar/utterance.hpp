// An utterance as the matcher sees it: tokens with what kind of word each is.
#pragma once

#include <string_view>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"
#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu {

struct Utterance {
  std::string_view text; // not owned
  Tokens tokens;
  std::vector<WordNumber> words;
  std::vector<bool> filler;   // means nothing: "er", "by the way"
  std::vector<bool> function; // means nothing by itself: "to", "the"
  std::vector<bool> negates;  // turns round what comes: "do not", "never"
  // Has a meaning of its own (a grammar's word, a filler, a function word), so
  // it is hardly part of an unknown name.
  std::vector<bool> plain;
  std::vector<float> weight; // what understanding this word counts for

  std::size_t size() const {
    return tokens.list.size();
  }
  // The weight of tokens [first, last).
  double weight_of(std::size_t first, std::size_t last) const;
  // Whether what begins there is not wanted: nothing that has a meaning of its
  // own stands between it and a word that turns it round.
  bool is_negated(std::size_t begin) const;
};

Utterance make_utterance(std::string_view text, const Automaton& automaton);

} // namespace parlour::adapters::nlu
