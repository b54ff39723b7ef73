// From an application and what a run wants to what a node is started with.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "actors/node/node.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {

struct RunWishes {
  std::string data_folder; // absolute
  std::optional<Timestamp> virtual_start;
  std::optional<std::uint64_t> seed;
};

// `composition` is the application's, or a changed copy of it.
actors::NodeOptions node_options(const Application& application,
                                 const Composition& composition,
                                 const RunWishes& wishes);

} // namespace parlour::tools
