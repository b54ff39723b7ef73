// What `parlour reload` asks of a running application, and what it is told: as
// JSON between the processes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "actors/node/node.hpp"
#include "runtime/base/error.hpp"

namespace parlour::tools {

struct ReloadRequest {
  actors::ReloadMode mode = actors::ReloadMode::keep;
  bool undo = false; // back to the scripts before the last change
};

// Either errors, and nothing has changed, or what has become of it.
struct ReloadReply {
  std::vector<std::string> errors; // lines
  std::vector<std::string> notes;  // lines
};

// Carries a request out; called by one thread at a time.
using Reload = std::function<ReloadReply(const ReloadRequest&)>;

std::string to_json(const ReloadRequest& request);
Expected<ReloadRequest> reload_request_from_json(const std::string& text);
std::string to_json(const ReloadReply& reply);
Expected<ReloadReply> reload_reply_from_json(const std::string& text);

// In words: how many conversations went over, what they have lost, which
// components were loaded.
std::vector<std::string> notes_of(const actors::ReloadOutcome& outcome,
                                  actors::ReloadMode mode);

} // namespace parlour::tools
