// ConfirmAnswers: what the answer to a script's <confirm> leads to (language
// rule 12.20).
#pragma once

#include "script/dialogue/context/asked.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/output/output_manager.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/topic_engine/refusals.hpp"
#include "script/dialogue/topic_engine/topic_changes.hpp"

namespace parlour::dialogue {

class ConfirmAnswers {
public:
  ConfirmAnswers(DialogueContext& context, TopicFrames& frames,
                 Confirmations& confirmations, Refusals& refusals,
                 TopicChanges& topic_changes)
      : context_(context), frames_(frames), confirmations_(confirmations),
        refusals_(refusals), topic_changes_(topic_changes) {}

  // Its script goes on.
  void answer_confirm(const Asked& asked, bool yes);
  // Who takes back the value that is asked about says no to it.
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
