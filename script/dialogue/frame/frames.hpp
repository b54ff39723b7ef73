// Frames: the frames of a session's topics, whose only owner it is (engine rule
// 5.12). What scripts must see at once (a <set>, a question asked) is changed
// here; a filling event goes with the frame to the topic's actor, whose answer
// takes the frame's place. A frame that was given away is never changed.
#pragma once

#include <span>
#include <vector>

#include "script/dialogue/frame/topic_frame.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// A frame is copied only when it is to be changed and somebody else may hold
// it: an actor, a query that waits. One that nobody else has is changed in
// place.
class Frames {
public:
  Frames(const script::Program& program, script::Interpreter& interpreter);

  // Made with the slots' initial values when first looked at.
  const TopicFrame& get(TopicId topic, Timestamp now) const {
    const auto& mine = entries_[topic];
    return mine.frame ? *mine.frame : *entry(topic, now).frame;
  }

  // Null where it was not looked at. Makes nothing.
  const TopicFrame* find(TopicId topic) const {
    return entries_[topic].frame.get();
  }

  // One event, in place (topic_frame.hpp); the result has no frame.
  FrameResult apply(TopicId topic, std::span<const FrameChange> changes,
                    Timestamp now);
  // What became of the topic's slots by it.
  SlotReports change(TopicId topic, const FrameChange& change, Timestamp now) {
    return apply(topic, {&change, 1}, now).reports;
  }
  void set_status(TopicId topic, TopicStatus status, Timestamp now) {
    dialogue::set_status(program_->topics[topic], own(topic, now), status);
  }
  void count_question(TopicId topic, SlotId slot, Timestamp now) {
    dialogue::count_question(own(topic, now), slot);
  }

  // What the actor is told: the frame, which it shares from now on, and
  // `changes`; variables and other topics' frames only where the program may
  // read them.
  FrameRequest request(TopicId topic, std::vector<FrameChange> changes,
                       Timestamp now);
  // The actor's answer: the topic's frame from now on.
  void store(FramePointer frame);

  template <class Archive>
  void serialize(Archive& archive) {
    archive.without(program_, interpreter_);
    for (TopicId topic = 0; topic < entries_.size(); ++topic) {
      const auto& [frame, own, is_made] = entries_[topic];
      archive(entries_[topic]);
      archive.check((!own || own == frame) && (!frame || frame->topic == topic),
                    "a frame is another topic's");
    }
  }

private:
  struct Entry {
    FramePointer frame;              // null: not touched
    std::shared_ptr<TopicFrame> own; // the same one, while nobody else has it
    bool is_made = false;            // now: it cannot be read yet

    template <class Archive>
    void serialize(Archive& archive) {
      archive.without(is_made);
      archive(frame, own);
    }
  };

  FrameEvaluator evaluator(Timestamp now) const;
  Entry& entry(TopicId topic, Timestamp now) const;
  TopicFrame& own(TopicId topic, Timestamp now); // to be changed

  const script::Program* program_;
  script::Interpreter* interpreter_;
  mutable ShortLivedList<Entry> entries_;
};

} // namespace parlour::dialogue
