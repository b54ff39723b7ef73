// What a TapListener does where nobody publishes; with a tap it is tested in
// message_tap_test.cpp.
#include <thread>

#include <gtest/gtest.h>

#include "adapters/agents/zeromq/tap_listener.hpp"

namespace parlour::adapters::agents {
namespace {

TEST(TapListener, EndsItsWait) {
  const auto listener = TapListener::connect("tcp://127.0.0.1:1", {}).value();
  std::jthread other([&] { listener->stop(); });
  EXPECT_EQ(listener->next(), std::nullopt);
  EXPECT_EQ(listener->next(), std::nullopt);
}

TEST(TapListener, NamesAnAddressThatIsNone) {
  for (const auto* wrong : {"tcp://", "nowhere", "tcp://127.0.0.1:port"}) {
    const auto listener = TapListener::connect(wrong, {});
    ASSERT_FALSE(listener) << wrong;
    EXPECT_EQ(listener.error().kind, ErrorKind::settings);
  }
}

} // namespace
} // namespace parlour::adapters::agents
