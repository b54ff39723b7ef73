// Frames: the session's view of its topics' frames. Reads are local; small
// changes (a script's <set>, a question asked) are made here at once and
// travel with the next request to the frame's actor (engine rule 5).
#pragma once

#include <vector>

#include "script/dialogue/frame.hpp"
#include "script/interpreter.hpp"

namespace parlour::dialogue {

class Frames {
public:
  Frames(const script::Program& program, script::Interpreter& interpreter);

  // Made with the slots' initial values when first looked at.
  const Frame& get(TopicId topic, Timestamp now) const;

  FrameResult change(TopicId topic, FrameChange change, Timestamp now);

  // What the actor must be told: all that was changed here since the last
  // request, then `changes`.
  FrameRequest request(TopicId topic, std::vector<FrameChange> changes,
                       Timestamp now);
  void store(FramePointer frame);

private:
  struct Entry {
    FramePointer frame; // null: not touched
    std::vector<FrameChange> untold;
    bool has_actor = false;
  };

  Entry& entry(TopicId topic, Timestamp now) const;

  const script::Program* program_;
  script::Interpreter* interpreter_;
  mutable std::vector<Entry> entries_;
};

} // namespace parlour::dialogue
