// Evaluates a topic's conditions and texts against a frame under construction:
// `this.X` reads that frame, effects are refused. Used by the session and by
// the topic-frame actor.
#pragma once

#include <memory>

#include "script/dialogue/frame/topic_frame.hpp"
#include "script/vm/interpreter.hpp"

namespace parlour::dialogue {

// With the session's own interpreter, whose variables it sees; both must
// outlive the evaluator.
FrameEvaluator make_frame_evaluator(script::Interpreter& interpreter,
                                    Timestamp now);

// With an interpreter of its own; `variables` are the session's, or null.
FrameEvaluator
make_frame_evaluator(std::shared_ptr<const script::Program> program,
                     std::shared_ptr<const List> variables, Timestamp now);

} // namespace parlour::dialogue
