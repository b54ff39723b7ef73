// What a node has counted, all in one list, for who watches it.
#pragma once

#include <cstdint>
#include <vector>

#include "actors/protocol/actor_status.hpp"
#include "actors/routing/routing_table.hpp"
#include "actors/support/node_metrics.hpp"
#include "runtime/base/journal.hpp"

namespace parlour::actors {

struct MetricSources {
  const NodeMetrics& node;
  const RoutingTable& table;              // with the counters of messages
  const std::vector<ActorStatus>& actors; // those of which a node has one
  std::int64_t in_flight = 0;
  const Journal* journal = nullptr; // null: there is none
};

Metrics collect_metrics(const MetricSources& sources);

} // namespace parlour::actors
