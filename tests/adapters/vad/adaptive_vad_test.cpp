#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/vad/adaptive_vad.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

TEST(AdaptiveVadTest, Conforms) {
  EXPECT_THAT(conformance_errors(adaptive_vad_factory(), {}),
              testing::IsEmpty());
}

TEST(AdaptiveVadTest, RefusesWrongOptions) {
  test::FakePluginHost host;
  auto starts = [&](const Options& options) {
    return adaptive_vad_factory().create()->start(host, options).has_value();
  };
  EXPECT_FALSE(starts({{"hangover", "1h"}}));
  EXPECT_FALSE(starts({{"echo-loss", "loud"}}));
  EXPECT_TRUE(starts({{"hangover", "100ms"}, {"echo-loss", "0"}}));
}

} // namespace
} // namespace parlour::adapters
