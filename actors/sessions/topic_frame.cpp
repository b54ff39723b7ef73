#include "actors/sessions/topic_frame.hpp"

#include <cassert>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/actor_trace.hpp"
#include "actors/support/exception_text.hpp"
#include "actors/support/tell_status.hpp"
#include "script/dialogue/frame/frame_evaluator.hpp"

namespace parlour::actors {

namespace {

// Constraints are scripts: they see the changed frame, and what the request
// brings of the session.
frame_changed change(const std::shared_ptr<const script::Program>& program,
                     const apply_changes& what) {
  const auto& request = *what.request;
  assert(request.frame && "a change leads from a frame to a frame");
  auto evaluate = dialogue::make_frame_evaluator(program, request.variables,
                                                 request.now, request.others);
  return {std::make_shared<const dialogue::FrameResult>(
              dialogue::apply(*program, request, evaluate)),
          what.work};
}

} // namespace

topic_frame_actor::behavior_type
topic_frame(topic_frame_actor::stateful_pointer<topic_frame_state> self,
            std::shared_ptr<const script::Program> program,
            script::TopicId topic, ActorTrace trace) {
  end_by_what_is_thrown(self);
  return traced<topic_frame_actor::behavior_type>(
      std::move(trace),
      [=](const apply_changes& what) { return change(program, what); },
      [=](const get_status& what) {
        return tell_status(self, what, {program->topics[topic].name});
      });
}

} // namespace parlour::actors
