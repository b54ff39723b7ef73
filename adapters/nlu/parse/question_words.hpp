// Which words of an answer the question has that waits for a yes or no. Pure.
#pragma once

#include <cstddef>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"

namespace parlour::adapters::nlu {

// Made for one utterance; both must outlive it.
class QuestionWords {
public:
  QuestionWords(const Utterance& utterance, const Context& context)
      : utterance_(utterance), context_(context) {}

  // Whether the question has the word, a synonym of it, or its number: "eight"
  // of "8am".
  bool has(std::size_t token) const;

  // "Yes, cancel it" to "Shall I cancel the call?": whether the act says no
  // more than one word of the question, of whatever it was about. Another
  // value, or a second thing of several, is something else that is wanted.
  bool has_all_of(const BuiltAct& act) const;

private:
  // Whether the question names the act itself: "cancel".
  bool is_named(const BuiltAct& act) const;
  bool has_number(std::size_t token) const;
  bool has_synonym(std::size_t token) const;

  const Utterance& utterance_;
  const Context& context_;
};

} // namespace parlour::adapters::nlu
