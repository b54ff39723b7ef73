// Other topics that an utterance may be about. Pure.
#pragma once

#include <vector>

#include "adapters/nlu/parse/built_act.hpp"
#include "adapters/nlu/understand/understood.hpp"

namespace parlour::adapters::nlu {

// Acts about other topics that score almost as high as the best one. The engine
// may ask the user which was meant.
struct Alternatives {
  std::vector<BuiltAct> acts;
  // They say the same of the same slot, so the dialogue engine chooses the
  // topic.
  bool same_slots = false;
};

// Only a chain of exactly one act is an alternative.
void add_alternative(Alternatives& alternatives, const BuiltAct& best,
                     std::vector<BuiltAct> acts);

// Puts the alternatives into the act, or leaves its topic open.
void add_alternatives(Understanding& made, const Alternatives& alternatives,
                      const Utterance& utterance, const Spans& spans,
                      const Schema& schema);

} // namespace parlour::adapters::nlu
