// TopicChanges: one topic becomes the current one, another is suspended for it
// (engine rule 5, "Which topic next").
#pragma once

#include <optional>
#include <utility>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/open_question.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/asking.hpp"
#include "script/dialogue/questions/confirmations.hpp"

namespace parlour::dialogue {

class TopicChanges {
public:
  TopicChanges(DialogueContext& context, TopicFrames& frames,
               OpenQuestion& question, Asking& asking,
               Confirmations& confirmations)
      : context_(context), frames_(frames), question_(question),
        asking_(asking), confirmations_(confirmations) {}

  void take(const steps::Activate& step);
  // It becomes the current one; the bodies that this runs are added.
  void begin_topic(TopicId topic, StepList& steps, bool keep = false);
  // A topic whose wait for the user is over is the current one: the steps that
  // this takes.
  StepList back_to(TopicId topic);
  // Back to it after silence, with its next question.
  void take_up(TopicId topic);
  // An enquiry has been answered, or cannot be.
  void answered(TopicId topic);
  // The suspended topic that waited for this one; or no_id.
  TopicId needed_by(TopicId topic) const;

  // If that topic begins again with its values, this act is what it takes.
  void keep_for(Act act) {
    late_ = std::move(act);
  }
  void forget() {
    late_.reset();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, frames_, question_, asking_, confirmations_);
    archive(late_);
  }

private:
  void begin_needs(TopicId topic, StepList& steps);
  void leave_enquiry(TopicId next);
  void suspend(TopicId topic, StepList& steps);

  DialogueContext& context_;
  TopicFrames& frames_;
  OpenQuestion& question_;
  Asking& asking_;
  Confirmations& confirmations_;
  std::optional<Act> late_; // a correction of a completed topic
};

} // namespace parlour::dialogue
