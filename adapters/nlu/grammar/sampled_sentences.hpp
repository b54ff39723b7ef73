// Sentences that the rules of an application say, with what they mean: random
// walks through the automaton. What is learnt from them knows also what is said
// in other words than a rule has (understanding/likeness.hpp).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "adapters/nlu/grammar/automaton.hpp"

namespace parlour::adapters::nlu {

// What stands for a value of this kind: "@7".
std::string value_word(EntityId entity);
// Its kind; nothing for any other word.
std::optional<EntityId> kind_of_word(std::string_view word);

// What a sentence means, apart from the values that are said in it.
struct SentenceMeaning {
  TopicNumber topic = no_topic;
  std::string act;
  // Slots that the rule fills by itself ({Aspect=price}), in order.
  std::vector<std::pair<std::string, Value>> literals;

  bool operator==(const SentenceMeaning&) const = default;
};

struct SampledSentence {
  // With a value_word() for each value; any words are left out. A question
  // about any words ends with that of words_entity, which nobody says.
  std::vector<std::string> words;
  SentenceMeaning meaning;
  // The slots that values of a kind fill.
  std::vector<std::pair<std::string, EntityId>> values;
};

// About `count` sentences, fewer if the rules say fewer; each once. Rules of
// the platform, bare values and rules that deny or correct are left out, as are
// those whose topic only the conversation tells. The same for equal automata.
std::vector<SampledSentence> sample_sentences(const Automaton& automaton,
                                              const Schema& schema,
                                              std::size_t count);

} // namespace parlour::adapters::nlu
