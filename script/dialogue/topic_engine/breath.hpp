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

// The lane never waits for the user's next words: the answer is kept here, and
// everything else goes on. At most one is kept, as a question is answered once.
// It belongs to the question that was open then: if another one is open when
// the rest has come, the answer is dropped.
class Breath {
public:
  Breath(DialogueContext& context, OpenQuestion& question)
      : context_(context), question_(question) {}

  // Whether more is being said: somebody speaks, or another turn is open. Then
  // the answer is kept, and the caller does nothing with it. A question must
  // wait.
  bool waits_for_more(const ActPointer& act, TurnId turn);
  // An act of a further turn: read together with the answer that was kept.
  // True: the step was moved from, and comes again behind the answer, both as
  // the acts of one utterance. False: the step is the caller's, as it was.
  bool joins(steps::TakeAct& step);
  // A yes or no waited for what else might follow in the same breath, and
  // nothing did: it is queued. To be called when the lane has nothing more to
  // do.
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
  // By output and wait: a question that was asked anew has another output.
  bool still_asked(const Unsettled& answer) const;

  DialogueContext& context_;
  OpenQuestion& question_;
  // Empty: no answer is kept.
  std::optional<Unsettled> unsettled_;
};

} // namespace parlour::dialogue
