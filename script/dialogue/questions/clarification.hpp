// Clarification: what may be about several topics: which one is meant is asked
// for (understanding, "Score").
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/questions/asking.hpp"
#include "script/dialogue/questions/whereabouts.hpp"

namespace parlour::dialogue {

class Clarification {
public:
  Clarification(DialogueContext& context, OpenQuestion& question,
                Asking& asking, Whereabouts& whereabouts)
      : context_(context), question_(question), asking_(asking),
        whereabouts_(whereabouts) {}

  // Whether the act might be about several topics: they are asked for.
  bool ask_which(const steps::Fill& step);
  // The same question, once more or for the first time.
  void ask_which_again(Asked asked, OutputAct as, TurnId turn);
  // "Do you mean A or B?" "Yes.": neither; but "yes, A" is an answer.
  bool leaves_open_which(const Act& act) const;
  // The answer to that: what was said before, about the topic that it names.
  void complete_by_answer(steps::TopicAct& step);

private:
  bool asks_which() const;

  DialogueContext& context_;
  OpenQuestion& question_;
  Asking& asking_;
  Whereabouts& whereabouts_;
};

} // namespace parlour::dialogue
