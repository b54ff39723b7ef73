#include "tools/parlour/application/live_application.hpp"

#include <sstream>
#include <utility>

namespace parlour::tools {

LiveApplication::LiveApplication(Application first, Open open, Options options)
    : open_(std::move(open)), options_(std::move(options)),
      now_(std::move(first)) {}

Expected<actors::ReloadOutcome>
LiveApplication::reload(actors::Node& node, actors::ReloadMode mode) {
  std::ostringstream out;
  std::ostringstream found;
  auto opened = open_(Console{out, found});
  if (std::holds_alternative<int>(opened))
    return fail(ErrorKind::settings, found.str());
  return change(node, std::move(std::get<Application>(opened)), mode);
}

Expected<actors::ReloadOutcome> LiveApplication::undo(actors::Node& node,
                                                      actors::ReloadMode mode) {
  if (!before_)
    return fail(ErrorKind::settings,
                "nothing has been changed since the application was started");
  return change(node, *before_, mode);
}

Expected<actors::ReloadOutcome>
LiveApplication::change(actors::Node& node, Application to,
                        actors::ReloadMode mode) {
  auto options = options_(to);
  auto outcome = node.reload({options.program, std::move(options.components),
                              options.phrases, options.understanding,
                              std::move(options.columns)},
                             mode);
  if (outcome)
    before_ = std::exchange(now_, std::move(to));
  return outcome;
}

} // namespace parlour::tools
