// What a running application does when `parlour reload` asks for it.
#pragma once

#include <sstream>

#include "tools/parlour/application/live_application.hpp"
#include "tools/parlour/status/reload_request.hpp"

namespace parlour::tools {

inline ReloadReply reload(LiveApplication& application, actors::Node& node,
                          const ReloadRequest& request) {
  const auto outcome = request.undo ? application.undo(node, request.mode)
                                    : application.reload(node, request.mode);
  ReloadReply reply;
  if (outcome) {
    reply.notes = notes_of(*outcome, request.mode);
    return reply;
  }
  std::istringstream lines(outcome.error().message);
  for (std::string line; std::getline(lines, line);)
    reply.errors.push_back(line);
  return reply;
}

} // namespace parlour::tools
