// LaneEntry: what the pipeline hands over becomes an item of the dialogue lane,
// which ends with the question that is then due. Who wants out, or to start
// over, does not wait for what waits there (engine rule 2).
#pragma once

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

class LaneEntry {
public:
  LaneEntry(DialogueContext& context, TopicEngine& topics,
            PushedStates& pushed_states)
      : context_(context), topics_(topics), pushed_states_(pushed_states) {}

  void take(StepList steps, TurnId turn);

private:
  DialogueContext& context_;
  TopicEngine& topics_;
  PushedStates& pushed_states_;
};

} // namespace parlour::dialogue
