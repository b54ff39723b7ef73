// The conformance test for plug-ins: checks the description, the commands and
// events of its roles (roles.def), and the contract of plugin.hpp. `parlour
// plugin test` runs it, and so can a plug-in's own unit tests.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/plugin/plugin.hpp"

namespace parlour {

struct TestOptions {
  Options options;
  // The longest time for one call, and for an answer.
  Milliseconds deadline{2'000};
  std::string data_folder;        // absolute, writable
  std::string application_folder; // absolute
  // Called before each call into the plug-in, with "start" or the command's
  // name. It tells where a plug-in crashes or hangs.
  std::function<void(const std::string& step)> on_step = {};
  // Until so long after an instance was started, an answer may take longer than
  // `deadline`: it may still load what it needs.
  Milliseconds warm_up{0};
};

// Runs the test and returns one sentence per fault; empty if the plug-in
// conforms. Creates, starts and stops several instances in the calling thread.
// A call that never returns cannot be ended: watch it from outside (on_step).
//
// It checks that the plug-in and its options are described; that it starts,
// stops and starts again, and that two instances can run at a time; that each
// REQUEST of its roles is answered with the session and correlation of the
// message; that a command with missing parameters and an unknown command are
// refused; that nothing is thrown; and that it fires only events that it has
// described.
std::vector<std::string> conformance_errors(const PluginFactory& factory,
                                            const TestOptions& options);

} // namespace parlour
