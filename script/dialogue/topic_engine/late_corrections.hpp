// LateCorrections: a correction of the topic that was completed last: a
// <repair> says what is done about it (engine rule 5.3).
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/repair_runner.hpp"
#include "script/dialogue/topic_engine/settling.hpp"
#include "script/dialogue/topic_engine/topic_changes.hpp"

namespace parlour::dialogue {

class LateCorrections {
public:
  LateCorrections(DialogueContext& context, TopicFrames& frames,
                  Confirmations& confirmations, RepairRunner& repairs,
                  TopicChanges& topic_changes, Settling& settling)
      : context_(context), frames_(frames), confirmations_(confirmations),
        repairs_(repairs), topic_changes_(topic_changes), settling_(settling) {}

  // False where the act is none.
  bool take(const steps::TopicAct& step);

private:
  DialogueContext& context_;
  TopicFrames& frames_;
  Confirmations& confirmations_;
  RepairRunner& repairs_;
  TopicChanges& topic_changes_;
  Settling& settling_;
};

} // namespace parlour::dialogue
