// Passes rows to a driver, and the driver for a node.
#include "tools/parlour/talk/text_run.hpp"

#include <algorithm>

#include "tools/parlour/talk/trace.hpp"

namespace parlour::tools {

NodeDriver::NodeDriver(actors::Node& node, bool is_virtual,
                       std::function<void(const std::string&)> say,
                       std::optional<dialogue::SavedSession> left)
    : node_(node), virtual_(is_virtual) {
  seat_ =
      node.open_seat({[this, say = std::move(say)](
                          const SessionId&, const dialogue::Output& output) {
                        ++said_;
                        say(as_one_line(output.text));
                      },
                      {}});
  if (!left || node.go_on(seat_, *std::move(left)).empty())
    node.open(seat_);
}

// Steps from one due time to the next, until the robot has said something or
// the earliest timer of the conversation has been reached. Delays of components
// (a sensor, a slow answer) do not end the step before longest_pause has
// passed.
void NodeDriver::let_time_pass() {
  const auto said = said_.load();
  auto end = node_.now() + longest_pause.count();
  do {
    if (const auto timer = node_.next_timer())
      end = std::min(end, *timer);
    if (!node_.step_to_next_due(longest_step))
      return;
  } while (said_ == said && node_.now() < end);
}

bool talk_by_rows(ConversationDriver& driver, RowReader& rows) {
  for (;;) {
    const auto event = rows.next();
    switch (event.kind) {
    case RowEvent::Kind::turns:
      driver.enter(event.turns);
      // In real time the node runs by itself while we read on. A part of a row
      // waits even then, so that input cannot outrun the node.
      if (driver.is_virtual() || event.is_part)
        driver.run_until_quiet();
      break;
    case RowEvent::Kind::quiet:
      driver.run_until_quiet();
      break;
    case RowEvent::Kind::step:
      driver.let_time_pass();
      break;
    case RowEvent::Kind::end:
      driver.run_until_quiet();
      return true;
    case RowEvent::Kind::interrupted:
      return false;
    }
  }
}

} // namespace parlour::tools
