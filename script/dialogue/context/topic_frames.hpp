// TopicFrames: the topics of one conversation: their frames, and which of them
// is current, suspended or resting. A topic that ends does so in both. Whoever
// watches is shown what changes.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "script/dialogue/context/dialogue_context.hpp"
#include "script/dialogue/frame/frames.hpp"
#include "script/dialogue/topics/topic_order.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// Owned by ConversationImplementation. Changes for scripts are made at once;
// those of the user go to the topic's actor where the port has one (engine rule
// 5.12).
class TopicFrames {
public:
  // Both must outlive it.
  TopicFrames(DialogueContext& context, script::Interpreter& interpreter);

  // The frame as it is now; the reference lasts until the next change.
  const TopicFrame& operator[](TopicId topic) const {
    return frames_.get(topic, context_.now);
  }
  // Whether the session has touched it. To look at one that it has not makes
  // the frame.
  bool has(TopicId topic) const {
    return frames_.find(topic) != nullptr;
  }
  // The first slot that is to be asked for, and the first that is in doubt; or
  // no_id.
  SlotId missing(TopicId topic) const;
  SlotId doubtful(TopicId topic) const;
  // Whether a slot may be asked for because it is missing. What is in doubt is
  // asked for in any case.
  bool may_ask(TopicId topic) const;

  // Judges anew which slots apply: variables may have changed since.
  void refresh(TopicId topic);

  // At once.
  void change(TopicId topic, const FrameChange& change);
  void set_status(TopicId topic, TopicStatus status);
  // The question for the slot was released: the next one is its <help> (engine
  // rule 5.9).
  void count_question(TopicId topic, SlotId slot);
  // One filling event: at once, or by the topic's actor, whose answer is
  // stored. `changes` may be moved from.
  FrameResult apply(TopicId topic, std::span<const FrameChange> changes);
  FrameRequest request(TopicId topic, std::vector<FrameChange> changes);
  // The frame that the actor has made takes the place of the one that it was
  // sent.
  void store(FramePointer frame);
  // Shows what became of a slot; a private value as ***.
  void inspect_report(TopicId topic, const SlotReport& report);

  // Another port is told of all slots that are private.
  void conceal();

  // A topic ends: it is neither current nor suspended any more.
  void complete(TopicId topic);
  void cancel(TopicId topic);
  void answered(TopicId topic); // an enquiry, whose slots are context now
  // All begin anew.
  void restart();

  TopicOrder& order() {
    return order_;
  }
  const TopicOrder& order() const {
    return order_;
  }
  // The enquiry whose slots are context.
  std::optional<TopicId> resting() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(context_);
    archive(frames_, order_);
  }

private:
  DialogueContext& context_;
  Frames frames_;
  TopicOrder order_;
};

} // namespace parlour::dialogue
