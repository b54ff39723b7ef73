// Breath: a yes or no that more may follow in the same breath is not acted on
// before that has been heard; both are read as one utterance (engine rule 5.8,
// language rule 12.20).
#pragma once

#include <optional>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"

namespace parlour::dialogue {

// A yes or no that is not acted on yet: more was said in the same breath, and
// is not understood so far.
struct Unsettled {
  ActPointer act;
  TurnId turn = 0;
  OutputId question = 0; // that it answers,
  WaitId wait = 0;       // and the <confirm> of that

  template <class Archive>
  void serialize(Archive& archive) {
    archive(act, turn, question, wait);
    archive.needs(act);
  }
};

class Breath {
public:
  Breath(DialogueContext& context, OpenQuestion& question)
      : context_(context), question_(question) {}

  // Whether more is being said: then the answer is kept.
  bool waits_for_more(const ActPointer& act, TurnId turn);
  // An act of a further turn: read together with the answer that was kept.
  bool joins(steps::TakeAct& step);
  // A yes or no waited for what else might follow in the same breath, and
  // nothing did: it is queued.
  bool nothing_followed();

  bool holds_an_answer() const {
    return unsettled_.has_value();
  }
  void forget() {
    unsettled_.reset();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, question_);
    archive(unsettled_);
  }

private:
  bool still_asked(const Unsettled& answer) const;

  DialogueContext& context_;
  OpenQuestion& question_;
  std::optional<Unsettled> unsettled_;
};

} // namespace parlour::dialogue
