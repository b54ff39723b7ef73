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

class TopicEnds {
public:
  TopicEnds(DialogueContext& context, TopicFrames& frames, TopicWords& words,
            OpenQuestion& question, Asking& asking,
            Confirmations& confirmations, Whereabouts& whereabouts)
      : context_(context), frames_(frames), words_(words), question_(question),
        asking_(asking), confirmations_(confirmations),
        whereabouts_(whereabouts) {}

  // The topics that the user wants out of.
  std::vector<TopicId> meant_by(const steps::Cancel& step) const;
  // The steps that end them as cancelled; the user is told.
  StepList cancel(const std::vector<TopicId>& topics, TurnId turn);
  void take(const steps::CancelTopic& step);
  void take(const steps::Reset& step);
  // The topic that "cancel" means; or no_id.
  TopicId to_cancel() const;

private:
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
