// TopicEnds: topics end as cancelled, or are emptied by a script (engine
// rule 5).
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/open_question.hpp"
#include "script/dialogue/questions/pushed_states.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/questions/whereabouts.hpp"
#include "script/dialogue/topic_engine/wait_ends.hpp"

namespace parlour::dialogue {

class TopicEnds {
public:
  TopicEnds(DialogueContext& context, PushedStates& pushed_states,
            TopicFrames& frames, TopicWords& words, OpenQuestion& question,
            Confirmations& confirmations, Whereabouts& whereabouts,
            WaitEnds& wait_ends)
      : context_(context), pushed_states_(pushed_states), frames_(frames),
        words_(words), question_(question), confirmations_(confirmations),
        whereabouts_(whereabouts), wait_ends_(wait_ends) {}

  void take(const steps::Cancel& step);
  void take(const steps::CancelTopic& step);
  void take(const steps::Reset& step);
  // The topic that "cancel" means; or no_id.
  TopicId to_cancel() const;

private:
  bool can_be_cancelled(TopicId topic) const;

  DialogueContext& context_;
  PushedStates& pushed_states_;
  TopicFrames& frames_;
  TopicWords& words_;
  OpenQuestion& question_;
  Confirmations& confirmations_;
  Whereabouts& whereabouts_;
  WaitEnds& wait_ends_;
};

} // namespace parlour::dialogue
