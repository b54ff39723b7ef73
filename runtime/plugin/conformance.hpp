// The conformance test that every plug-in of a role passes: what roles.def says
// of the role, and the contract of plugin.hpp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

struct TrialTerms {
  Options options;
  // How long an answer may take; also one call.
  Milliseconds deadline{2'000};
  std::string data_folder;        // absolute, writable
  std::string application_folder; // absolute
  // Told what comes before each call: "start", or the command's name. So who
  // watches knows where a plug-in crashes or hangs.
  std::function<void(const std::string& step)> on_step = {};
};

// What is wrong with the plug-in, a sentence each; empty where it conforms.
// Makes, starts and stops several instances in the calling thread; a call that
// never returns is not ended.
//
// It describes itself and its options; it starts, stops and starts again, two
// at a time; each command that is always answered is, with the session and the
// correlation of the message; what lacks its parameters, and a command that
// nobody knows, is refused; nothing is thrown; it fires what it says it fires.
std::vector<std::string> nonconformities(const PluginFactory& factory,
                                         const TrialTerms& terms);

} // namespace parlour
