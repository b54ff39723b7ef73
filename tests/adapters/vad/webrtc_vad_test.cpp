#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/vad/webrtc_detector.hpp"
#include "adapters/vad/webrtc_vad.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

TEST(WebRtcVadTest, Conforms) {
  if (!make_webrtc_detector({}))
    GTEST_SKIP() << "built without libwebrtc-audio-processing";
  EXPECT_THAT(conformance_errors(webrtc_vad_factory(), {}), testing::IsEmpty());
}

TEST(WebRtcVadTest, RefusesWrongOptions) {
  test::FakePluginHost host;
  auto starts = [&](const Options& options) {
    return webrtc_vad_factory().create()->start(host, options).has_value();
  };
  EXPECT_FALSE(starts({{"hangover", "1h"}}));
  EXPECT_FALSE(starts({{"echo-loss", "loud"}}));
  EXPECT_FALSE(starts({{"strictness", "4"}}));
}

} // namespace
} // namespace parlour::adapters
