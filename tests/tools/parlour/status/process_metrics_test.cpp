#include <gtest/gtest.h>

#include "tools/parlour/status/process_metrics.hpp"

namespace parlour::tools {
namespace {

TEST(ProcessMetrics, ThisProcessHasMemoryTimeAndAThread) {
  const auto all = process_metrics();
  for (const auto* name : {"process_resident_memory_bytes",
                           "process_cpu_seconds_total", "process_threads"}) {
    ASSERT_NE(find(all, name), nullptr) << name;
    EXPECT_GT(find(all, name)->samples.at(0).value, 0) << name;
  }
  EXPECT_GT(all.at(0).samples.at(0).value, 1e6);
}

} // namespace
} // namespace parlour::tools
