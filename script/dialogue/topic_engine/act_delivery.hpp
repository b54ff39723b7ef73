// ActDelivery: what an act says is given to the topic that it is about, which
// becomes the current one (engine rules 5.3 and 5.11).
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/topic_words.hpp"
#include "script/dialogue/topic_engine/course/topic_changes.hpp"
#include "script/dialogue/topic_engine/filling.hpp"

namespace parlour::dialogue {

// TopicActs calls it, with the topic already chosen. What was said may be cut
// down or completed by what was asked. It keeps nothing.
class ActDelivery {
public:
  ActDelivery(DialogueContext& context, TopicFrames& frames, TopicWords& words,
              OpenQuestion& question, Confirmations& confirmations,
              TopicChanges& topic_changes, Filling& filling)
      : context_(context), frames_(frames), words_(words), question_(question),
        confirmations_(confirmations), topic_changes_(topic_changes),
        filling_(filling) {}

  // `step.act` is never null here. The topic begins or goes on first; its
  // <started> or <resumed> runs before the slots are filled.
  void give_to_topic(steps::Fill&& step);

private:
  // Engine rule 5.14, "any value, when `more` was asked".
  void add_to_what_is_there(steps::Fill& step);
  // Engine rule 5.3, step 7.
  void keep_what_is_asked(steps::Fill& step);

  DialogueContext& context_;
  TopicFrames& frames_;
  TopicWords& words_;
  OpenQuestion& question_;
  Confirmations& confirmations_;
  TopicChanges& topic_changes_;
  Filling& filling_;
};

} // namespace parlour::dialogue
