#include "actors/sessions/topic_frame.hpp"

#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/support/thrown.hpp"
#include "script/dialogue/frame/frame_evaluator.hpp"

namespace parlour::actors {

namespace {

using Self = topic_frame_actor::stateful_pointer<topic_frame_state>;

frame_changed change(Self self,
                     const std::shared_ptr<const script::Program>& program,
                     script::TopicId topic, const apply_changes& what) {
  const auto& request = *what.request;
  auto& frame = self->state.frame;
  auto evaluate =
      dialogue::make_frame_evaluator(program, request.variables, request.now);
  if (request.start)
    frame = request.start;
  else if (!frame)
    frame = std::make_shared<const dialogue::Frame>(
        dialogue::new_frame(*program, topic, evaluate));
  auto result = std::make_shared<const dialogue::FrameResult>(
      dialogue::apply(*program, *frame, request, evaluate));
  frame = result->frame;
  return {std::move(result), what.work};
}

} // namespace

topic_frame_actor::behavior_type
topic_frame(topic_frame_actor::stateful_pointer<topic_frame_state> self,
            std::shared_ptr<const script::Program> program,
            script::TopicId topic) {
  end_by_what_is_thrown(self);
  return {
      [=](const apply_changes& what) {
        return change(self, program, topic, what);
      },
  };
}

} // namespace parlour::actors
