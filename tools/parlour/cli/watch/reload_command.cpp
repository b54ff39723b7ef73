// `parlour reload`: tells a running application that its files have changed
// (docs/operations.md).
#include <ostream>

#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"
#include "tools/parlour/status/reload_request.hpp"
#include "tools/parlour/status/running_nodes.hpp"

namespace parlour::tools {

namespace {

// It compiles the application, and components load models.
constexpr Milliseconds patience{120'000};

actors::ReloadMode mode_of(const ReloadOptions& options) {
  if (options.restart)
    return actors::ReloadMode::restart;
  return options.new_only ? actors::ReloadMode::new_only
                          : actors::ReloadMode::keep;
}

Expected<ReloadReply> ask_reload(const RunningNode& node,
                                 const ReloadRequest& request) {
  return answer_to(node.socket,
                   std::string(questions::reload) + " " + to_json(request),
                   patience)
      .and_then(reload_reply_from_json);
}

} // namespace

int reload_command(const Places& places, const ReloadOptions& options,
                   const Console& console) {
  const auto node = the_node(places, options.app);
  const auto reply =
      node ? ask_reload(*node, {mode_of(options), options.undo})
           : Expected<ReloadReply>(tl::make_unexpected(node.error()));
  if (!reply) {
    say_error(console, reply.error().message);
    return exit_code::wrong;
  }
  if (!reply->errors.empty()) {
    for (const auto& line : reply->errors)
      console.err << line << '\n';
    say_error(console, node->application + " goes on unchanged");
    return exit_code::wrong;
  }
  for (const auto& note : reply->notes)
    console.out << note << '\n';
  return exit_code::success;
}

} // namespace parlour::tools
