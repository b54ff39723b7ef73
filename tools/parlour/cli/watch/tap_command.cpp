// `parlour tap`: prints the messages of a running application (docs/agents.md).
#include <ostream>

#include <fmt/format.h>

#include "adapters/agents/wire/parameters.hpp"
#include "adapters/agents/zeromq/tap_listener.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/printer.hpp"
#include "tools/parlour/console/signal_watch.hpp"

namespace parlour::tools {

namespace {

using namespace adapters::agents;

// One message on a line, or why it cannot be read.
std::string line_of(const Read<AgentMessage>& copy) {
  auto message = copy ? message_from_agent(*copy, true)
                      : Read<Message>(tl::make_unexpected(copy.error()));
  return message ? to_string(*message)
                 : "this is no message: " + message.error().sentence;
}

// Numbers tell what was missed; where only some messages are listened to, they
// tell nothing.
class Gaps {
public:
  explicit Gaps(bool hears_all) : hears_all_(hears_all) {}

  std::uint64_t before(const AgentMessage& message) {
    const auto number = message.number.value_or(0);
    const auto missed =
        hears_all_ && last_ != 0 && number > last_ ? number - last_ - 1 : 0;
    last_ = number;
    return missed;
  }

private:
  const bool hears_all_;
  std::uint64_t last_ = 0;
};

} // namespace

int tap_command(const TapOptions& options, const Console& console) {
  SignalWatch signals; // before any other thread
  auto listener =
      TapListener::connect("tcp://" + options.connect, options.beginnings);
  if (!listener) {
    say_error(console, to_string(listener.error()));
    return exit_code::usage;
  }
  Printer printer(console.out, console.err,
                  [&signals] { signals.raise_closed(); });
  signals.on_interrupt([&] {
    (*listener)->stop();
    printer.give_up();
  });
  Gaps gaps(options.beginnings.empty());
  while (const auto copy = (*listener)->next()) {
    if (const auto missed = *copy ? gaps.before(**copy) : 0; missed > 0)
      printer.err(fmt::format("missed {} messages", missed));
    printer.wait_for_room();
    printer.out(line_of(*copy));
  }
  signals.on_interrupt(nullptr);
  printer.finish();
  return signals.status();
}

} // namespace parlour::tools
