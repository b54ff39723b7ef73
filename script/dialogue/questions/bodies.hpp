// Bodies of topics and slots become steps.
#pragma once

#include "script/dialogue/agenda/step_list.hpp"

namespace parlour::dialogue {

// At the end of the steps; nothing where there is no such body.
inline void run_body(CodeId code, TopicId topic, SlotId slot, TurnId turn,
                     StepList& steps) {
  if (code != script::no_code)
    steps.add(
        steps::Run{{.code = code, .topic = topic, .slot = slot, .turn = turn}});
}

} // namespace parlour::dialogue
