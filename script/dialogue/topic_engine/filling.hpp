// Filling: an act's values go to the frame's actor as one filling event (engine
// rule 5).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "script/dialogue/agenda/step_list.hpp"
#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/context/messenger.hpp"
#include "script/dialogue/context/topic_frames.hpp"
#include "script/dialogue/questions/confirmations.hpp"
#include "script/dialogue/questions/next_question.hpp"
#include "script/dialogue/questions/whereabouts.hpp"
#include "script/dialogue/topic_engine/filling_outcome.hpp"

namespace parlour::dialogue {

// It begins filling events and waits for their frames (engine rules 5.4 and
// 5.12). At most one is awaited. Who calls it: ActDelivery with an act, the
// lane with a Fill step, and YesOrNoOutcome with the answer to a value in
// doubt.
class Filling {
public:
  Filling(DialogueContext& context, Messenger& messenger, TopicFrames& frames,
          Confirmations& confirmations, Whereabouts& whereabouts,
          NextQuestion& next_question, FillingOutcome& outcome)
      : context_(context), messenger_(messenger), frames_(frames),
        confirmations_(confirmations), whereabouts_(whereabouts),
        next_question_(next_question), outcome_(outcome) {}

  // `step.act` must not be null. <confirm>s of the topic's <filled> and rules
  // ask about the topic as it was: they are ended first, with an error of kind
  // Cancelled, and the step is taken again.
  void take(steps::Fill&& step);
  // One event of the topic's frame; a step without act is a yes or no to a
  // value. `changes` may be moved from. Either the outcome is dealt with before
  // this returns, or awaits_frame() holds, and frame_applied() goes on.
  void request(steps::Fill&& step, std::vector<FrameChange>& changes);
  // The actor's answer. awaits_frame() must hold; the frame replaces the one
  // that the session has.
  void frame_applied(FrameResult result);

  // Another port is asked for the frame; nothing where none is awaited. A
  // filling event is pure, so it may be asked for twice (engine rule 7.9).
  void resume() const;

  bool awaits_frame() const {
    return awaiting_.has_value();
  }
  // The session ends: the frame's answer is wanted no more.
  void forget_frame() {
    awaiting_.reset();
  }

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_, messenger_, frames_, confirmations_, whereabouts_,
                    next_question_, outcome_, changes_);
    archive(awaiting_);
  }

private:
  void note_changes(const steps::Fill& step,
                    std::vector<FrameChange>& changes) const;
  FrameChange inherit(const steps::Fill& step) const;
  void tell_filled(steps::Fill& step, FrameResult result);

  DialogueContext& context_;
  Messenger& messenger_;
  TopicFrames& frames_;
  Confirmations& confirmations_;
  Whereabouts& whereabouts_;
  NextQuestion& next_question_;
  FillingOutcome& outcome_;
  std::vector<FrameChange> changes_; // empty between two steps: its memory
  // The step whose frame is awaited, and the request, in case that another port
  // has to be asked.
  struct Awaited {
    steps::Fill step;
    std::shared_ptr<const FrameRequest> request;

    template <class Archive>
    void serialize(Archive& archive) {
      archive(step, request);
      archive.needs(request);
    }
  };
  std::optional<Awaited> awaiting_; // for the frame's actor
};

} // namespace parlour::dialogue
