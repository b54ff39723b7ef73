// Clarification: what may be about several topics: which one is meant is asked
// for (understanding, "Score").
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/questions/asking.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/questions/whereabouts.hpp"

namespace parlour::dialogue {

// TopicActs calls it: with each act, for an answer to the question that it has
// asked, and before a filling event, to ask. What was said meanwhile waits in
// the question (`Asked::act`), not here.
class Clarification {
public:
  Clarification(DialogueContext& context, OpenQuestion& question,
                TopicWords& words, Asking& asking, Whereabouts& whereabouts)
      : context_(context), question_(question), words_(words), asking_(asking),
        whereabouts_(whereabouts) {}

  // Whether the act might be about several topics: they are asked for, and
  // nothing is filled. Only the first act of an utterance has alternatives.
  bool ask_which(const steps::Fill& step);
  // The same question, once more or for the first time. `asked.act` is what was
  // said.
  void ask_which_again(Asked asked, OutputAct as, TurnId turn);
  // "Do you mean A or B?" "Yes.": neither; but "yes, A" is an answer. False
  // where this was not asked.
  bool leaves_open_which(const Act& act) const;
  // The answer to that: what was said before, about the topic that it names.
  // The question is answered by whatever comes. Nothing happens where it was
  // not asked.
  void complete_by_answer(steps::TopicAct& step);

private:
  // Its label, else its name: the way to say it aloud.
  Value called(TopicId topic) const;
  bool asks_which() const;

  DialogueContext& context_;
  OpenQuestion& question_;
  TopicWords& words_;
  Asking& asking_;
  Whereabouts& whereabouts_;
};

} // namespace parlour::dialogue
