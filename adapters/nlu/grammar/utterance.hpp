// An utterance as the matcher sees it: tokens, with what is known of each word.
#pragma once

#include <string_view>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"
#include "adapters/nlu/text/tokens.hpp"

namespace parlour::adapters::nlu {

// From this weight on, words have a meaning of their own.
inline constexpr double full_weight = 1;

// The vectors have one entry for each token.
struct Utterance {
  // Not owned, like the automaton; both must outlive the utterance.
  std::string_view text;
  const Automaton* automaton = nullptr;
  Tokens tokens;
  std::vector<WordNumber> words;
  // As which other words they may be read; of the automaton, null for none.
  std::vector<const Automaton::Synonyms*> synonyms;
  // Has no meaning: "er", "by the way".
  std::vector<bool> filler;
  // Has no meaning by itself: "to", "the".
  std::vector<bool> function;
  // Negates what follows: "do not", "never".
  std::vector<bool> negates;
  // Has a meaning of its own (a word of a grammar, a filler, a function word),
  // so it is hardly part of an unknown name.
  std::vector<bool> plain;
  // What understanding this word is worth: 0 for a filler, 0.5 for a function
  // word, 1 for any other.
  std::vector<float> weight;

  std::size_t size() const {
    return tokens.list.size();
  }
  // Whether one of these tokens is a word with a meaning of its own.
  bool has_content(std::size_t first, std::size_t last) const;
  // The sum of the weights of tokens [first, last).
  double weight_of(std::size_t first, std::size_t last) const;
  // Whether a negation applies to what begins at this token: between the two
  // stand only fillers and linking words.
  bool is_negated(std::size_t begin) const;
};

Utterance make_utterance(std::string_view text, const Automaton& automaton);

} // namespace parlour::adapters::nlu
