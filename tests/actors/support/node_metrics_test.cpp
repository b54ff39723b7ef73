#include <set>

#include <gtest/gtest.h>

#include "actors/support/node_metrics.hpp"

namespace parlour::actors {
namespace {

TEST(NodeMetrics, TellsWhatWasCounted) {
  NodeMetrics metrics;
  metrics.sessions_opened.add(5);
  metrics.sessions_recovered.add(2);
  metrics.sessions_ended.add(3);
  metrics.turn_time.observe(1'000'000);
  metrics.component("Ear").failures.add(2);
  metrics.component("Ear").restarts.add();
  metrics.component("Mouth").failures.add();
  const auto told = metrics.told();
  const auto value = [&](const char* name) {
    return find(told, name)->samples.at(0).value;
  };
  EXPECT_EQ(value("parlour_sessions"), 4);
  EXPECT_EQ(value("parlour_sessions_opened_total"), 5);
  EXPECT_EQ(find(told, "parlour_turn_seconds")->samples.at(0).time.count(), 1u);
  const auto* failures = find(told, "parlour_component_failures_total");
  ASSERT_EQ(failures->samples.size(), 2u);
  EXPECT_EQ(failures->samples[0].labels.at(0).second, "Ear");
  EXPECT_EQ(failures->samples[0].value, 2);
}

// As Prometheus wants it.
TEST(NodeMetrics, NamesSayWhatIsCounted) {
  std::set<std::string> names;
  for (const auto& metric : NodeMetrics().told()) {
    EXPECT_TRUE(names.insert(metric.name).second) << metric.name;
    EXPECT_TRUE(metric.name.starts_with("parlour_")) << metric.name;
    EXPECT_EQ(metric.kind == MetricKind::counter,
              metric.name.ends_with("_total"))
        << metric.name;
    EXPECT_EQ(metric.kind == MetricKind::histogram,
              metric.name.ends_with("_seconds"))
        << metric.name;
    EXPECT_EQ(metric.sentence.back(), '.');
  }
}

TEST(NodeMetrics, TimeNeverGoesBack) {
  const auto before = NodeMetrics::now();
  EXPECT_GT(before, 0);
  EXPECT_GE(NodeMetrics::now(), before);
}

} // namespace
} // namespace parlour::actors
