// NodeMetrics: what a node counts of itself (node_metrics.def). Owned by its
// observer.
#pragma once

#include <map>
#include <mutex>
#include <string>

#include "runtime/base/metrics.hpp"

namespace parlour::actors {

// Safe to use from any thread; nobody waits but for the seldom counters of
// components.
// Counters are members, so that counting is one atomic addition; components
// have theirs by name, as they come and go.
class NodeMetrics {
public:
#define NODE_COUNTER(member, name, sentence) Counter member;
#define NODE_HISTOGRAM(member, name, sentence) Histogram member;
#include "actors/support/node_metrics.def"

  struct OfComponent {
#define COMPONENT_COUNTER(member, name, sentence) Counter member;
#include "actors/support/node_metrics.def"
  };
  // Lives as long as the node.
  OfComponent& component(const std::string& name);

  // For latencies: a time that never goes back, of this process.
  static Nanoseconds now();

  // All of it as of about now, as `/metrics` shows it.
  Metrics told() const;

private:
  mutable std::mutex mutex_;
  std::map<std::string, OfComponent> components_;
};

} // namespace parlour::actors
