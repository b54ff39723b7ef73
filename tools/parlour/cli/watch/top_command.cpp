// `parlour top`: shows how a running application does, again each second on a
// terminal (docs/operations.md).
#include <chrono>
#include <ostream>

#include "adapters/loop/wait_until_ready.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/console/signal_watch.hpp"
#include "tools/parlour/status/running_nodes.hpp"
#include "tools/parlour/status/top_view.hpp"

namespace parlour::tools {

namespace {

constexpr auto pause_between = std::chrono::seconds(1);
constexpr const char* to_the_top = "\x1b[H";
constexpr const char* clear_below = "\x1b[J";
constexpr const char* clear_line = "\x1b[K";

Expected<MetricsReport> ask_metrics(const RunningNode& node) {
  return answer_to(node.socket, questions::metrics).and_then(metrics_from_json);
}

// What a longer line has left behind is wiped away.
std::string on_screen(const std::string& view) {
  std::string text = to_the_top;
  for (const char c : view)
    text += c == '\n' ? std::string(clear_line) + c : std::string(1, c);
  return text + clear_below;
}

// Until a signal comes, or the application ends.
int go_on(const RunningNode& node, MetricsReport last, const Console& console) {
  SignalWatch signals;
  console.out << clear_below << on_screen(top_view(last)) << std::flush;
  for (;;) {
    pollfd signal[] = {{signals.descriptor(), POLLIN, 0}};
    if (adapters::wait_until_ready(signal, std::chrono::steady_clock::now() +
                                               pause_between) !=
        adapters::Waited::late)
      return signals.status();
    auto now = ask_metrics(node);
    if (!now) {
      say_error(console, node.application + " does not run any more");
      return exit_code::wrong;
    }
    console.out << on_screen(top_view(*now, last)) << std::flush;
    last = std::move(*now);
  }
}

} // namespace

int top_command(const Places& places, const TopOptions& options,
                const Console& console) {
  const auto node = the_node(places, options.app);
  auto told = node ? ask_metrics(*node)
                   : Expected<MetricsReport>(tl::make_unexpected(node.error()));
  if (!told) {
    say_error(console, told.error().message);
    return exit_code::wrong;
  }
  if (console.redraws && !options.once)
    return go_on(*node, std::move(*told), console);
  console.out << top_view(*told);
  return exit_code::success;
}

} // namespace parlour::tools
