// HeardGrammar: tells the recogniser which grammar is expected next, as a state
// or the slot that is asked for says (language rule 12.18), before anybody
// speaks.
#pragma once

#include <string>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/questions/whereabouts.hpp"

namespace parlour::dialogue {

// Called after each input (go_on), so that several changes during one input
// post one message.
class HeardGrammar {
public:
  // All must outlive it.
  HeardGrammar(DialogueContext& context, Messenger& messenger,
               const Whereabouts& whereabouts);

  // Posts SetGrammar to the role ASR if another grammar is expected than was
  // told last; does nothing as long as there is no recogniser.
  void tell();

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, messenger_, whereabouts_);
    archive.without(is_used_); // as the program says
    archive(told_);
  }

private:
  DialogueContext& context_;
  Messenger& messenger_;
  const Whereabouts& whereabouts_;
  // Whether any state or slot of the program names a grammar; else nothing is
  // ever posted.
  bool is_used_;
  // What the recogniser was told last; empty: all grammars, which it expects at
  // first.
  std::string told_;
};

} // namespace parlour::dialogue
