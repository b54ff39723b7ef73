#include "actors/support/node_metrics.hpp"

#include <chrono>

namespace parlour::actors {

namespace {

double number(std::uint64_t count) {
  return static_cast<double>(count);
}

} // namespace

NodeMetrics::OfComponent& NodeMetrics::component(const std::string& name) {
  const std::lock_guard lock(mutex_);
  return components_[name];
}

Nanoseconds NodeMetrics::now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

// What ends is read first: there are never more of them than have begun.
Metrics NodeMetrics::told() const {
  const auto ended = number(sessions_ended.value());
  const auto begun =
      number(sessions_opened.value() + sessions_recovered.value());
  Metrics all = {metric("parlour_sessions", MetricKind::gauge,
                        "Sessions that are open.", begun - ended)};
#define NODE_COUNTER(member, name, sentence)                                   \
  all.push_back(                                                               \
      metric(name, MetricKind::counter, sentence, number(member.value())));
#define NODE_HISTOGRAM(member, name, sentence)                                 \
  all.push_back(metric(name, sentence, member));
#include "actors/support/node_metrics.def"
  const std::lock_guard lock(mutex_);
#define COMPONENT_COUNTER(member, name, sentence)                              \
  all.push_back({name, MetricKind::counter, sentence});                        \
  for (const auto& [component, its] : components_)                             \
    all.back().samples.push_back(                                              \
        {{{"component", component}}, number(its.member.value())});
#include "actors/support/node_metrics.def"
  return all;
}

} // namespace parlour::actors
