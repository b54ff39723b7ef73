// Evaluates a topic's conditions and texts against a frame under construction:
// `this.X` reads that frame, effects are refused. Used by the session and by
// the topic-frame actor.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "script/dialogue/frame/topic_frame.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// The frame of another topic, whose slots are read; null: it has no values.
using FindFrame = std::function<const TopicFrame*(TopicId topic)>;

// With the session's own interpreter, whose variables it sees; both must
// outlive the evaluator. Without `others`, slots of other topics are unknown.
FrameEvaluator make_frame_evaluator(script::Interpreter& interpreter,
                                    Timestamp now, FindFrame others = {});

// With an interpreter of its own; `variables` are the session's, or null;
// `others` are the frames of other topics that were touched.
FrameEvaluator
make_frame_evaluator(std::shared_ptr<const script::Program> program,
                     std::shared_ptr<const List> variables, Timestamp now,
                     std::vector<FramePointer> others = {});

} // namespace parlour::dialogue
