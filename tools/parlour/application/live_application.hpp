// LiveApplication: the application of a running node, which can be changed to
// what its files say by now, and back.
#pragma once

#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>

#include "actors/node/node.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/console/console.hpp"

namespace parlour::tools {

// Not thread-safe: one change at a time.
class LiveApplication {
public:
  // Opens the application as the run has opened it. Its findings go to the
  // console; where there are errors it returns a status.
  using Open = std::function<std::variant<Application, int>(const Console&)>;
  // What the node would be started with.
  using Options = std::function<actors::NodeOptions(const Application&)>;

  LiveApplication(Application first, Open open, Options options);

  // The node goes over to what the files say now. An error leaves all as it
  // was; its message may have several lines.
  Expected<actors::ReloadOutcome> reload(actors::Node& node,
                                         actors::ReloadMode mode);
  // The node goes back to what it had before the last change; another call
  // brings that one again.
  Expected<actors::ReloadOutcome> undo(actors::Node& node,
                                       actors::ReloadMode mode);

private:
  Expected<actors::ReloadOutcome> change(actors::Node& node, Application to,
                                         actors::ReloadMode mode);

  const Open open_;
  const Options options_;
  Application now_;
  std::optional<Application> before_;
};

} // namespace parlour::tools
