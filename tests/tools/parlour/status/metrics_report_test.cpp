#include <gtest/gtest.h>

#include "tools/parlour/status/metrics_report.hpp"

namespace parlour::tools {
namespace {

TEST(MetricsReport, IsReadAsItWasWritten) {
  Histogram time;
  time.observe(1'000'000);
  Metric up{"up", MetricKind::gauge, ""};
  up.samples.push_back({{{"component", "Ear"}, {"role", "ASR"}}, 0.5});
  const MetricsReport report{
      "desk", "/apps/desk", 42, 10'000, {up, metric("took_seconds", "", time)}};
  const auto read = metrics_from_json(to_json(report));
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(to_json(*read), to_json(report));
  EXPECT_EQ(read->process, 42);
  EXPECT_EQ(read->metrics.at(0).samples.at(0).labels.at(1).second, "ASR");
  EXPECT_EQ(read->metrics.at(1).samples.at(0).time.count(), 1u);
}

TEST(MetricsReport, WhatIsNoneIsAnError) {
  for (const auto* text : {"", "{}", "[]", "{\"application\": 7}"})
    EXPECT_FALSE(metrics_from_json(text)) << text;
}

} // namespace
} // namespace parlour::tools
