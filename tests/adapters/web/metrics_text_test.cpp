#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/web/metrics_text.hpp"

namespace parlour::adapters::web {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(MetricsText, NamesKindsAndValues) {
  Metric lost{"lost_total", MetricKind::counter, "What\nwas lost \\."};
  lost.samples = {{{}, 3},
                  {{{"component", "a \"b\"\n\\"}, {"role", "TTS"}}, 1e15}};
  EXPECT_EQ(
      metrics_text({lost, metric("open", MetricKind::gauge, "Now.", 0.5)}),
      "# HELP lost_total What\\nwas lost \\\\.\n"
      "# TYPE lost_total counter\n"
      "lost_total 3\n"
      "lost_total{component=\"a \\\"b\\\"\\n\\\\\",role=\"TTS\"} "
      "1000000000000000\n"
      "# HELP open Now.\n# TYPE open gauge\nopen 0.5\n");
}

TEST(MetricsText, AHistogramTellsHowManyAreUpToEachBound) {
  Histogram time;
  time.observe(9'000);
  time.observe(100'000);
  time.observe(200'000'000'000);
  const auto text = metrics_text({metric("took_seconds", "How long.", time)});
  EXPECT_THAT(text, StartsWith("# HELP took_seconds How long.\n"
                               "# TYPE took_seconds histogram\n"
                               "took_seconds_bucket{le=\"1e-05\"} 1\n"));
  EXPECT_THAT(text, HasSubstr("\ntook_seconds_bucket{le=\"7e-05\"} 1\n"
                              "took_seconds_bucket{le=\"0.0001\"} 2\n"));
  EXPECT_THAT(text, HasSubstr("\ntook_seconds_bucket{le=\"70\"} 2\n"
                              "took_seconds_bucket{le=\"+Inf\"} 3\n"
                              "took_seconds_sum 200.000109\n"
                              "took_seconds_count 3\n"));
}

} // namespace
} // namespace parlour::adapters::web
