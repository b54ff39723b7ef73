#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/push_to_talk/key_push_to_talk.hpp"
#include "runtime/plugin/conformance.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/adapters/push_to_talk/fake_keys.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr Milliseconds patience{60'000};

class KeyPushToTalkTest : public testing::Test {
protected:
  ~KeyPushToTalkTest() override {
    if (plugin)
      plugin->stop();
  }
  Expected<void> start(Options options = {}) {
    options.emplace("device", keys.path());
    plugin = key_push_to_talk_factory(Milliseconds(1)).create();
    return plugin->start(host, options);
  }
  void send(const std::string& command) {
    Message message;
    message.command = command;
    plugin->receive(message);
  }
  // The next events, once there are so many.
  std::string events(std::size_t count) {
    host.wait(
        [&] {
          for (const auto& event : host.take_events())
            seen.push_back(event.command);
          return seen.size() >= count;
        },
        patience);
    std::string all;
    for (const auto& event : std::exchange(seen, {}))
      all += event + " ";
    return all;
  }

  test::FakeKeys keys;
  TestHost host;
  std::unique_ptr<IPlugin> plugin;
  std::vector<std::string> seen;
};

TEST_F(KeyPushToTalkTest, Conforms) {
  TestOptions options;
  options.options = {{"device", keys.path()}};
  EXPECT_THAT(conformance_errors(key_push_to_talk_factory(), options),
              IsEmpty());
}

TEST_F(KeyPushToTalkTest, TellsOfTheKey) {
  ASSERT_TRUE(start());
  keys.press();
  keys.repeat();
  keys.release();
  EXPECT_EQ(events(2), "Pressed Released ");
}

TEST_F(KeyPushToTalkTest, MayBePressedTwice) {
  ASSERT_TRUE(start({{"press", "twice"}, {"key", "f5"}}));
  keys.press(KEY_F5);
  keys.release(KEY_F5);
  EXPECT_EQ(events(1), "Pressed ");
  keys.press(KEY_F5);
  EXPECT_EQ(events(1), "Released ");
}

TEST_F(KeyPushToTalkTest, DoesNotCountWhileItIsDisabled) {
  ASSERT_TRUE(start());
  keys.press();
  EXPECT_EQ(events(1), "Pressed ");
  send("Disable");
  EXPECT_EQ(events(1), "Released ");
  send("Enable");
  keys.release();
  keys.press();
  EXPECT_EQ(events(1), "Pressed ");
}

TEST_F(KeyPushToTalkTest, ComesBackWithItsDevice) {
  ASSERT_TRUE(start());
  keys.press();
  EXPECT_EQ(events(1), "Pressed ");
  keys.unplug();
  EXPECT_EQ(events(1), "Released ");
  EXPECT_TRUE(host.wait([&] { return !host.is_available(); }, patience));
  keys.plug_in();
  EXPECT_TRUE(host.wait([&] { return host.is_available(); }, patience));
  keys.press();
  EXPECT_EQ(events(1), "Pressed ");
}

TEST_F(KeyPushToTalkTest, MayBeAKeyThatNobodyPresses) {
  EXPECT_THAT(conformance_errors(unpressed_key_factory(), {}), IsEmpty());
  const auto starts = [&](const Options& options) {
    return unpressed_key_factory().create()->start(host, options).has_value();
  };
  EXPECT_TRUE(starts({{"device", "/nowhere"}}));
  EXPECT_FALSE(starts({{"key", "spacebar"}}));
  EXPECT_FALSE(starts({{"press", "often"}}));
}

TEST_F(KeyPushToTalkTest, RefusesToStart) {
  EXPECT_THAT(start({{"key", "spacebar"}}).error().message,
              HasSubstr("is no key"));
  EXPECT_THAT(start({{"press", "often"}}).error().message,
              HasSubstr("\"hold\" or \"twice\""));
  keys.unplug();
  EXPECT_THAT(start().error().message, HasSubstr("there is no such device"));
}

} // namespace
} // namespace parlour::adapters
