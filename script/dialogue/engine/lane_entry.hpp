// LaneEntry: what the pipeline hands over becomes an item of the dialogue lane,
// which ends with the question that is then due. Who wants out, or to start
// over, does not wait for what waits there (engine rule 2).
#pragma once

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/engine/state_machine.hpp"
#include "script/dialogue/topic_engine/topic_engine.hpp"

namespace parlour::dialogue {

class LaneEntry {
public:
  LaneEntry(DialogueContext& context, TopicEngine& topics,
            StateMachine& machine)
      : context_(context), topics_(topics), machine_(machine) {}

  // `wait`: for which the script that handed them over waits now; or 0. What it
  // asked before is given up.
  void take(StepList acts, TurnId turn, WaitId wait = 0);

private:
  DialogueContext& context_;
  TopicEngine& topics_;
  StateMachine& machine_;
};

} // namespace parlour::dialogue
