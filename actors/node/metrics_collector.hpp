// What a node has counted, all in one list, for who watches it.
#pragma once

#include <cstdint>
#include <vector>

#include "actors/protocol/actor_status.hpp"
#include "actors/routing/routing_table.hpp"
#include "actors/support/node_metrics.hpp"
#include "runtime/base/outside/journal.hpp"

namespace parlour::actors {

// All of it is only read, and only during the call.
struct MetricSources {
  const NodeMetrics& node;
  const RoutingTable& table;              // with the counters of messages
  const std::vector<ActorStatus>& actors; // those of which a node has one
  std::int64_t in_flight = 0;
  const Journal* journal = nullptr; // null: there is none
};

// With the names and labels of docs/operations.md. From any thread; counters go
// on meanwhile, so that two figures need not fit each other exactly.
Metrics collect_metrics(const MetricSources& sources);

} // namespace parlour::actors
