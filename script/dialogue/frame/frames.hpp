// Frames: the session's view of its topics' frames. Reads are local; small
// changes (a script's <set>, a question asked) are made here at once, in place
// while nobody else has the frame, which travels with the next request to its
// actor (engine rule 5).
#pragma once

#include <span>
#include <vector>

#include "script/dialogue/frame/frame.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

class Frames {
public:
  Frames(const script::Program& program, script::Interpreter& interpreter);

  // Made with the slots' initial values when first looked at.
  const Frame& get(TopicId topic, Timestamp now) const {
    const auto& mine = entries_[topic];
    return mine.frame ? *mine.frame : *entry(topic, now).frame;
  }

  // One event, in place (frame.hpp); the result has no frame.
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

  // What the actor must be told: the frame, where it was changed here since
  // its last answer, and `changes`.
  FrameRequest request(TopicId topic, std::vector<FrameChange> changes,
                       Timestamp now);
  void store(FramePointer frame);

private:
  struct Entry {
    FramePointer frame;         // null: not touched
    std::shared_ptr<Frame> own; // the same one, while nobody else has it
  };

  Entry& entry(TopicId topic, Timestamp now) const;
  Frame& own(TopicId topic, Timestamp now); // to be changed

  const script::Program* program_;
  script::Interpreter* interpreter_;
  mutable ShortLivedList<Entry> entries_;
};

} // namespace parlour::dialogue
