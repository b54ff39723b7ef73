#include "tools/bench/support/quiet_port.hpp"

#include <utility>

namespace parlour::tools {

void QuietPort::run(dialogue::Conversation& conversation) {
  do
    while (!playing_.empty()) {
      const auto id = playing_.back();
      playing_.pop_back();
      conversation.output_finished(id, true, 0);
    }
  while (conversation.step(0) || !playing_.empty());
}

void QuietPort::be_silent(dialogue::Conversation& conversation) {
  conversation.timer_fired(timer_, 0);
  run(conversation);
}

void QuietPort::release(const dialogue::Output& output) {
  said_ += output.text.size() + (said_ > 0 ? 1 : 0);
  playing_.push_back(output.id);
}

void QuietPort::inspect(Inspection inspection) {
  if (inspection.kind == InspectionKind::error)
    trouble_ = inspection.detail;
}

} // namespace parlour::tools
