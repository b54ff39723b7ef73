// TopicEnds: topics end as cancelled, or are emptied by a script (engine
// rule 5).
#pragma once

#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/asking.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/questions/whereabouts.hpp"

namespace parlour::dialogue {

// The lane's Cancel step comes from a <cancel> of a script, mostly the
// platform's <repair act="cancel">. The conversation first asks here whom it
// means, ends the waits of these topics, and then takes the steps that are made
// here. It keeps nothing.
class TopicEnds {
public:
  TopicEnds(DialogueContext& context, TopicFrames& frames, TopicWords& words,
            OpenQuestion& question, Asking& asking,
            Confirmations& confirmations, Whereabouts& whereabouts)
      : context_(context), frames_(frames), words_(words), question_(question),
        asking_(asking), confirmations_(confirmations),
        whereabouts_(whereabouts) {}

  // The topics that the user wants out of: all unfinished ones, the one that
  // the step names, or what "cancel" means now. Empty: there is nothing to
  // cancel.
  std::vector<TopicId> meant_by(const steps::Cancel& step) const;
  // The steps that end them as cancelled. The user is told once, also where
  // nothing was to be cancelled, as silence would sound like a refusal.
  StepList cancel(const std::vector<TopicId>& topics, TurnId turn);
  // One topic ends as cancelled; its <cancelled> runs. What needs it as a part
  // ends as well, silently.
  void take(const steps::CancelTopic& step);
  // Slots go back to their initial values, the status to untouched; no body of
  // the topic runs.
  void take(const steps::Reset& step);
  // The topic that "cancel" means: the one whose question waits, else the
  // current one, the one whose <completed> waits for a yes, the one suspended
  // last; or no_id.
  TopicId to_cancel() const;

private:
  // What is completed is over, unless its <completed> waits for a yes and has
  // done nothing so far (engine rule 5.8).
  bool can_be_cancelled(TopicId topic) const;

  DialogueContext& context_;
  TopicFrames& frames_;
  TopicWords& words_;
  OpenQuestion& question_;
  Asking& asking_;
  Confirmations& confirmations_;
  Whereabouts& whereabouts_;
};

} // namespace parlour::dialogue
