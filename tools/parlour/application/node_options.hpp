// Makes the options for actors::Node from an application and the wishes of a
// run. `parlour run` and `parlour test` add their callbacks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "actors/node/node.hpp"
#include "adapters/agents/server/agent_server.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

// What a run chooses.
struct RunWishes {
  std::string data_folder; // absolute
  // Virtual time starts here; without, time is real.
  std::optional<Timestamp> virtual_start;
  std::optional<std::uint64_t> seed;      // without: chosen by chance
  bool restores_after_each_input = false; // actors/node/node_options.hpp
  // Where remote agents connect; null: their stand-ins take their places.
  std::shared_ptr<adapters::agents::AgentServer> agents = {};
};

// `composition` is the application's or a changed copy, such as rehearsed().
// The options share the program and the plug-ins, so the application itself may
// go.
actors::NodeOptions node_options(const Application& application,
                                 const Composition& composition,
                                 const RunWishes& wishes);

} // namespace parlour::tools
