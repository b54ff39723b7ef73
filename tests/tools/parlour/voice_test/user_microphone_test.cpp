#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/fake_plugin_host.hpp"
#include "tools/parlour/voice_test/user_microphone.hpp"

namespace parlour::tools {
namespace {

using adapters::Sound;
using testing::Each;

TEST(UserSound, is_the_line_over_the_noise) {
  UserSound sound(Sound(300, 5));
  sound.say(Sound(400, 100));
  EXPECT_FALSE(sound.is_silent());
  EXPECT_THAT(sound.next(), Each(105));
  EXPECT_FALSE(sound.is_silent());
  Sound rest(320, 5);
  std::fill_n(rest.begin(), 80, adapters::Sample{105});
  EXPECT_EQ(sound.next(), rest);
  EXPECT_TRUE(sound.is_silent());
}

TEST(UserSound, is_silence_without_both) {
  UserSound sound;
  EXPECT_TRUE(sound.is_silent());
  EXPECT_EQ(sound.next(), Sound(320));
}

class UserMicrophoneTest : public testing::Test {
protected:
  UserMicrophoneTest() {
    EXPECT_TRUE(microphone->start(host, {}));
  }
  void send(const char* command) {
    Message message;
    message.command = command;
    microphone->receive(message);
  }
  // With positions.
  std::string events() {
    std::string all;
    for (const auto& event : std::exchange(host.events, {}))
      all += event.command +
             (event.params.size() == 2 ? event.params[1].text() : "") + " ";
    return all;
  }

  test::FakePluginHost host;
  std::unique_ptr<IPlugin> microphone =
      user_microphone_factory(std::make_shared<UserSound>()).create();
};

TEST_F(UserMicrophoneTest, hears_20_ms_at_a_time) {
  send("start_mic");
  EXPECT_EQ(events(), "Started ");
  host.advance(Milliseconds(40));
  EXPECT_EQ(events(), "BufferFull0 BufferFull20 ");
}

TEST_F(UserMicrophoneTest, is_started_once) {
  send("start_mic");
  send("start_mic");
  EXPECT_EQ(host.pending(), 1u);
}

TEST_F(UserMicrophoneTest, stops) {
  send("start_mic");
  send("stop_mic");
  EXPECT_EQ(events(), "Started Stopped ");
  EXPECT_EQ(host.pending(), 0u);
}

} // namespace
} // namespace parlour::tools
