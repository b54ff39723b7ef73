// ConfirmAnswers: what the answer to a script's <confirm> leads to (language
// rule 12.20).
#pragma once

#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/topic_engine/course/refusals.hpp"
#include "script/dialogue/topic_engine/course/topic_changes.hpp"

namespace parlour::dialogue {

// The script's activation is resumed by a step, with true for yes and false for
// no; which of <yes> and <no> runs is compiled into the script. It keeps
// nothing.
class ConfirmAnswers {
public:
  ConfirmAnswers(DialogueContext& context, TopicFrames& frames,
                 Confirmations& confirmations, Refusals& refusals,
                 TopicChanges& topic_changes)
      : context_(context), frames_(frames), confirmations_(confirmations),
        refusals_(refusals), topic_changes_(topic_changes) {}

  // Its script goes on. `asked` must be a copy: the entry that it stands for is
  // removed here.
  void answer_confirm(const Asked& asked, bool yes);
  // Who takes back the value that is asked about says no to it. Nothing happens
  // where no <confirm> of that slot's <filled> waits.
  void heed_denial(TopicId topic, SlotId slot);

private:
  void settle_confirmed(const Asked& asked, bool yes);

  DialogueContext& context_;
  TopicFrames& frames_;
  Confirmations& confirmations_;
  Refusals& refusals_;
  TopicChanges& topic_changes_;
};

} // namespace parlour::dialogue
