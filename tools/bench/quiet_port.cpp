#include "tools/bench/quiet_port.hpp"

#include <utility>

namespace parlour::tools {

QuietPort::QuietPort(const std::shared_ptr<const script::Program>& program)
    : interpreter_(program),
      evaluate_(dialogue::make_frame_evaluator(interpreter_, 0)),
      frames_(program->topics.size()) {}

void QuietPort::run(dialogue::Conversation& conversation) {
  for (;;)
    if (applied_)
      conversation.frame_applied(*std::exchange(applied_, {}), 0);
    else if (!playing_.empty()) {
      const auto id = playing_.back();
      playing_.pop_back();
      conversation.output_finished(id, true, 0);
    } else if (conversation.has_work())
      conversation.step(0);
    else
      return;
}

void QuietPort::be_silent(dialogue::Conversation& conversation) {
  conversation.timer_fired(timer_, 0);
  run(conversation);
}

void QuietPort::release(const dialogue::Output& output) {
  said_ += output.text.size() + (said_ > 0 ? 1 : 0);
  playing_.push_back(output.id);
}

void QuietPort::apply(script::TopicId topic, dialogue::FrameRequest request) {
  auto& frame = frames_[topic];
  if (request.start)
    frame = request.start;
  applied_ =
      dialogue::apply(interpreter_.program(), *frame, request, evaluate_);
  frame = applied_->frame;
}

void QuietPort::inspect(Inspection inspection) {
  if (inspection.kind == InspectionKind::error)
    trouble_ = inspection.detail;
}

} // namespace parlour::tools
