// The sentences of an utterance that may be read by themselves: "Yes, please.
// Could the children go for a swim at that hour?" What was learnt knows whole
// texts only, and so none that has two. Pure.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "adapters/nlu/grammar/utterance.hpp"
#include "adapters/nlu/parse/built_act.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu {

struct SentenceApart {
  std::string_view text; // of the utterance
  // The indices of the acts that it says.
  std::vector<std::size_t> acts;
  // Whether it is written or begins as a question of more than a word or two.
  bool is_question = false;
};

// In the order of the utterance; none if it is one sentence. Left out are
// sentences of small words, which say nothing by themselves, and those of which
// an act has words of others, too.
std::vector<SentenceApart> sentences_apart(const Utterance& utterance,
                                           const std::vector<BuiltAct>& acts);

// Whether this act, which rules understood in one sentence, is said beside what
// was learnt of all together: certainly, with values, and about something else
// or what was learnt without any; or, where nothing was, surely.
bool is_said_alone(const Value& act, const List& learnt);
// Puts these acts before what was learnt, and in its place if they are about
// the same.
void put_before(List alone, List& learnt);

} // namespace parlour::adapters::nlu
