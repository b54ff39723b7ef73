// Classifies the words of an utterance. An unknown word weighs as much as a
// known one, so that words which were not understood lower the score.
#include "adapters/nlu/grammar/utterance.hpp"

#include "adapters/nlu/text/negation.hpp"
#include "adapters/nlu/text/words.hpp"

namespace parlour::adapters::nlu {

namespace {

using Phrase = std::vector<std::string>;

// The filler phrases by their first word, so that each token needs one look-up.
const TextMap<std::vector<Phrase>>& phrases() {
  static const auto table = [] {
    TextMap<std::vector<Phrase>> made;
    for (const auto phrase : filler_phrases()) {
      Phrase words;
      for (auto& token : tokenize(phrase).list)
        words.push_back(std::move(token.word));
      made[words[0]].push_back(std::move(words));
    }
    return made;
  }();
  return table;
}

// Whether the phrase stands at this position.
bool stands_at(const Phrase& phrase, const Tokens& tokens,
               std::size_t position) {
  if (position + phrase.size() > tokens.list.size())
    return false;
  for (std::size_t at = 0; at < phrase.size(); ++at)
    if (tokens.list[position + at].word != phrase[at])
      return false;
  return true;
}

void mark_fillers(Utterance& utterance) {
  for (std::size_t at = 0; at < utterance.size(); ++at) {
    const auto found = phrases().find(utterance.tokens.list[at].word);
    if (found == phrases().end())
      continue;
    for (const auto& phrase : found->second)
      if (stands_at(phrase, utterance.tokens, at))
        for (std::size_t word = 0; word < phrase.size(); ++word)
          utterance.filler[at + word] = true;
  }
}

} // namespace

double Utterance::weight_of(std::size_t first, std::size_t last) const {
  double sum = 0;
  for (auto at = first; at < last && at < weight.size(); ++at)
    sum += weight[at];
  return sum;
}

// Goes back from `begin` to the negation. A comma or full stop ends the search.
bool Utterance::is_negated(std::size_t begin) const {
  for (auto at = begin; at > 0; --at) {
    if (tokens.list[at].before != Break::none)
      return false;
    if (negates[at - 1])
      return true;
    if (!filler[at - 1] && !is_linking_word(tokens.list[at - 1].word))
      return false;
  }
  return false;
}

Utterance make_utterance(std::string_view text, const Automaton& automaton) {
  Utterance made;
  made.text = text;
  made.tokens = tokenize(text);
  const auto size = made.size();
  made.filler.resize(size);
  mark_fillers(made);
  made.negates = negations(made.tokens);
  for (std::size_t at = 0; at < size; ++at) {
    const auto& word = made.tokens.list[at].word;
    made.words.push_back(automaton.word(word));
    made.function.push_back(is_function_word(word));
    // A word that a grammar uses is not part of a name that is unknown.
    made.plain.push_back(made.filler[at] || made.function[at] ||
                         is_title(word) || made.words[at] != unknown_word);
    made.weight.push_back(made.filler[at]     ? 0.0F
                          : made.function[at] ? 0.5F
                                              : 1.0F);
  }
  return made;
}

} // namespace parlour::adapters::nlu
