#include "tools/parlour/talk/text_run.hpp"

#include <algorithm>

#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

NodePartner::NodePartner(actors::Node& node, bool is_virtual,
                         std::function<void(const std::string&)> say)
    : node_(node), virtual_(is_virtual) {
  seat_ =
      node.open_seat({[this, say = std::move(say)](
                          const SessionId&, const dialogue::Output& output) {
                        ++said_;
                        say(as_one_line(output.text));
                      },
                      {}});
  node.open(seat_);
}

void NodePartner::let_time_pass() {
  const auto said = said_.load();
  auto end = node_.now() + longest_pause.count();
  do {
    if (const auto timer = node_.next_timer())
      end = std::min(end, *timer);
    if (!node_.step_to_next_due(longest_step))
      return;
  } while (said_ == said && node_.now() < end);
}

bool talk_by_rows(Partner& partner, RowReader& rows) {
  for (;;) {
    const auto event = rows.next();
    switch (event.kind) {
    case RowEvent::Kind::turns:
      partner.enter(event.turns);
      // In real time the world goes on by itself while we read.
      if (partner.is_virtual() || event.is_part)
        partner.run_until_quiet();
      break;
    case RowEvent::Kind::quiet:
      partner.run_until_quiet();
      break;
    case RowEvent::Kind::step:
      partner.let_time_pass();
      break;
    case RowEvent::Kind::end:
      partner.run_until_quiet();
      return true;
    case RowEvent::Kind::interrupted:
      return false;
    }
  }
}

} // namespace parlour::tools
