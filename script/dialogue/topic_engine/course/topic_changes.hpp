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

// The one place where the current topic changes, whoever wants it: an act, a
// script's <activate>, silence, or a part that is completed. Statuses, the
// order of suspended topics, the open question and the bodies <started>,
// <resumed> and <suspended> are kept in step here.
class TopicChanges {
public:
  TopicChanges(DialogueContext& context, TopicFrames& frames,
               OpenQuestion& question, Asking& asking,
               Confirmations& confirmations)
      : context_(context), frames_(frames), question_(question),
        asking_(asking), confirmations_(confirmations) {}

  // Nothing happens for no_id and for a topic that does not take part. Either
  // the correction that was kept for the topic is filled, or the topic settles.
  void take(const steps::Activate& step);
  // A slot's own topic begins (engine rule 5.15), with its initial values and
  // those of `step.with`.
  void take(const steps::Part& step);
  // The steps back to a topic that needs the one which is completed. If a slot
  // of `topic` is filled by `completed`, they fill it with a map of its values.
  StepList back_to_needing(TopicId topic, TopicId completed, TurnId turn);
  // It becomes the current one, at once; the bodies that this runs are added to
  // `steps`, which the caller gives to the lane. `keep`: a completed topic
  // begins with the values that it has. It may be the current one already.
  void begin_topic(TopicId topic, StepList& steps, bool keep = false);
  // A topic whose wait for the user is over is the current one: the steps that
  // this takes. None where it is not suspended, or no_id.
  StepList back_to(TopicId topic);
  // Back to it after silence, or after a yes to "Shall we go on?", with its
  // next question.
  void take_up(TopicId topic);
  // An enquiry has been answered, or cannot be: it rests, and its question
  // waits no more.
  void answered(TopicId topic);
  // The suspended topic that waited for this one; or no_id.
  TopicId needed_by(TopicId topic) const;

  // If the topic that the act names begins again with its values, this act is
  // what it takes. A later act takes its place.
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
  // `with`: a map of slot names; what is no map gives no values.
  void begin_anew(TopicId topic, const Value& with);
  ActPointer result_for(TopicId topic, TopicId part) const;
  void begin_needs(TopicId topic, StepList& steps);
  // The current topic, where `next` takes its place.
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
