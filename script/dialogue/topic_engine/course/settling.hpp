// Settling: what a filling event leads to (engine rule 5): the topic is done,
// must be looked up, or asks for what is in doubt.
#pragma once

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/running_script.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/topic_engine/course/enquiries.hpp"
#include "script/dialogue/topic_engine/course/refusals.hpp"
#include "script/dialogue/topic_engine/course/topic_changes.hpp"

namespace parlour::dialogue {

// Steps of a task: Settle, its <filled>, Finish, Complete, its <completed>,
// WindUp. At each of them a script may have led elsewhere, and the rest is not
// done. A topic settles after each filling event, and where it begins or goes
// on without one.
class Settling {
public:
  Settling(DialogueContext& context, RunningScript& running,
           TopicFrames& frames, OpenQuestion& question,
           Confirmations& confirmations, Refusals& refusals,
           TopicChanges& topic_changes, Enquiries& enquiries)
      : context_(context), running_(running), frames_(frames),
        question_(question), confirmations_(confirmations), refusals_(refusals),
        topic_changes_(topic_changes), enquiries_(enquiries) {}

  // `step.result` is null where no filling event came before: then nothing was
  // refused. If a <confirm> of the topic waits, it is made anew and comes
  // first. A task that is not done, or not active, is left as it is.
  void take(steps::Settle&& step);
  // The topic's <filled> has run.
  void take(const steps::Finish& step);
  // Also by a script's <complete/>. Nothing happens if the topic is not active,
  // suspended or resting.
  void take(const steps::Complete& step);
  // The topic's <completed> has run.
  void take(const steps::WindUp& step);

  // When a topic was completed last; 0: none was.
  Timestamp completed_at() const {
    return completed_at_;
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, running_, frames_, question_, confirmations_,
                    refusals_, topic_changes_, enquiries_);
    archive(completed_at_);
  }

private:
  // True: the question is on its way, and the topic is not completed now.
  bool asks_for_refused(const steps::Settle& step);
  void settle_enquiry(const steps::Settle& step);

  DialogueContext& context_;
  RunningScript& running_;
  TopicFrames& frames_;
  OpenQuestion& question_;
  Confirmations& confirmations_;
  Refusals& refusals_;
  TopicChanges& topic_changes_;
  Enquiries& enquiries_;
  Timestamp completed_at_ = 0; // the latest topic
};

} // namespace parlour::dialogue
