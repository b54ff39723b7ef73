// `parlour tail`: follows what happens in a running application
// (docs/operations.md).
#include <ostream>

#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/printer.hpp"
#include "tools/parlour/console/signal_watch.hpp"
#include "tools/parlour/status/running_nodes.hpp"

namespace parlour::tools {

namespace {

// Prints lines until a signal comes or the application ends. While the printer
// has no room, nothing is read: the other side loses what does not fit.
int follow(const Descriptor& socket, SignalWatch& signals, Printer& printer) {
  std::string waiting;
  char buffer[16'384];
  for (;;) {
    pollfd ready[] = {{signals.descriptor(), POLLIN, 0},
                      {socket.get(), POLLIN, 0}};
    if (adapters::wait_until_ready(ready) == adapters::Waited::failed ||
        ready[0].revents != 0)
      return signals.status();
    const auto size = ::read(socket.get(), buffer, sizeof buffer);
    if (size <= 0)
      return exit_code::success; // it has ended
    waiting.append(buffer, static_cast<std::size_t>(size));
    for (std::size_t end; (end = waiting.find('\n')) != std::string::npos;) {
      printer.wait_for_room();
      printer.out(waiting.substr(0, end));
      waiting.erase(0, end + 1);
    }
  }
}

} // namespace

int tail_command(const Places& places, const TailOptions& options,
                 const Console& console) {
  SignalWatch signals; // before any other thread
  auto socket =
      the_node(places, options.app).and_then([&](const RunningNode& node) {
        return ask(node.socket, std::string(questions::tail) + " " +
                                    to_json(options.filter));
      });
  if (!socket) {
    say_error(console, socket.error().message);
    return exit_code::wrong;
  }
  Printer printer(console.out, console.err,
                  [&signals] { signals.raise_closed(); });
  signals.on_interrupt([&printer] { printer.give_up(); });
  const auto status = follow(*socket, signals, printer);
  signals.on_interrupt(nullptr);
  printer.finish();
  return status;
}

} // namespace parlour::tools
