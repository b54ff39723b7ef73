// Frames: the session's view of its topics' frames. Reads are local; small
// changes (a script's <set>, a question asked) are made here at once, in place
// while nobody else has the frame, which travels with the next request to its
// actor (engine rule 5).
#pragma once

#include <vector>

#include "script/dialogue/frame.hpp"
#include "script/interpreter.hpp"

namespace parlour::dialogue {

class Frames {
public:
  Frames(const script::Program& program, script::Interpreter& interpreter);

  // Made with the slots' initial values when first looked at.
  const Frame& get(TopicId topic, Timestamp now) const {
    const auto& mine = entries_[topic];
    return mine.frame ? *mine.frame : *entry(topic, now).frame;
  }

  // What became of the topic's slots by it.
  std::vector<SlotReport> change(TopicId topic, const FrameChange& change,
                                 Timestamp now);

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

  const script::Program* program_;
  script::Interpreter* interpreter_;
  mutable std::vector<Entry> entries_;
};

} // namespace parlour::dialogue
