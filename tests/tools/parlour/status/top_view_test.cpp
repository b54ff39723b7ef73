#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/status/top_view.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class TopViewTest : public testing::Test {
protected:
  // After so many seconds and turns of a millisecond.
  MetricsReport report(double seconds, int turns) {
    using enum MetricKind;
    Histogram time;
    for (int i = 0; i < turns; ++i)
      time.observe(1'000'000);
    Metric up{"parlour_component_up", gauge, ""};
    up.samples = {{{{"component", "Ear"}, {"role", "ASR"}}, 1},
                  {{{"component", "Mouth"}, {"role", "TTS"}}, 0}};
    Metric failures{"parlour_component_failures_total", counter, ""};
    failures.samples = {{{{"component", "Mouth"}}, 5}};
    return {"desk",
            "/apps/desk",
            42,
            0,
            {metric("parlour_uptime_seconds", gauge, "", seconds),
             metric("parlour_sessions", gauge, "", 3),
             metric("parlour_turns_total", counter, "", turns),
             metric("parlour_turn_seconds", "", time),
             metric("process_resident_memory_bytes", gauge, "", 48e6), up,
             failures}};
  }
};

TEST_F(TopViewTest, TellsOfTheWholeTimeAtFirst) {
  EXPECT_THAT(
      top_view(report(3'725, 7'450)),
      AllOf(StartsWith("desk (process 42, /apps/desk), up 1:02:05\n"),
            HasSubstr("\nsessions  3 open, "),
            HasSubstr("\nturns     2.0/s, p50 0.85 ms, p99 1.00 ms; 7450 in "
                      "all"),
            HasSubstr("48 MB in memory"), Not(HasSubstr("journal"))));
}

TEST_F(TopViewTest, TellsOfTheTimeSinceTheOneBefore) {
  auto now = report(11, 1'030);
  const auto text = top_view(now, report(10, 1'000));
  EXPECT_THAT(text, HasSubstr("\nturns     30.0/s, p50 0.85 ms"));
  EXPECT_THAT(top_view(report(11, 0), report(10, 0)),
              HasSubstr("turns     0.0/s, p50 -, p99 -"));
}

TEST_F(TopViewTest, AComponentIsALine) {
  EXPECT_THAT(
      top_view(report(1, 0)),
      HasSubstr("component  role  state  mailbox  messages  failures  "
                "restarts\n"
                "Ear        ASR   up     0        0.0/s     0         0\n"
                "Mouth      TTS   down   0        0.0/s     5         0\n"));
}

TEST_F(TopViewTest, AJournalThatCannotBeWrittenIsSeen) {
  using enum MetricKind;
  auto now = report(1, 0);
  now.metrics.push_back(
      metric("parlour_journal_records_total", counter, "", 10));
  now.metrics.push_back(metric("parlour_journal_writable", gauge, "", 0));
  EXPECT_THAT(top_view(now), AllOf(HasSubstr("\njournal   10.0/s records"),
                                   HasSubstr("CANNOT BE WRITTEN")));
}

} // namespace
} // namespace parlour::tools
