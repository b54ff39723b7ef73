#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/playout_speaker.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class TestedSpeaker : public PlayoutSpeaker {
public:
  // Plays everything at once.
  void changed() override {
    ++changes;
    std::vector<Sample> out(16'000);
    tell(with_playout([&](Playout& playout) {
      playout.pull(out);
      return playout.events(playout.pulled());
    }));
  }
  Expected<void> ready() override {
    if (is_gone)
      return fail(ErrorKind::offline, "the device is gone");
    return {};
  }

  int changes = 0;
  bool is_gone = false;
};

class PlayoutSpeakerTest : public testing::Test {
protected:
  PlayoutSpeakerTest() {
    EXPECT_TRUE(speaker.start(host, {}));
  }
  void send(std::string command, std::vector<Value> params) {
    speaker.receive(test::message(std::move(command), std::move(params)));
  }

  test::FakePluginHost host;
  TestedSpeaker speaker;
};

TEST_F(PlayoutSpeakerTest, CommandsGoToThePlayout) {
  send("Mark", {5, "hello", 0});
  send("Play", {pcm_value(std::vector<Sample>(1'600, 1)), 5});
  EXPECT_THAT(host.take_events(), ElementsAre("Started(5)"));
  send("Finish", {5});
  EXPECT_THAT(host.take_events(),
              ElementsAre("Finished(5, 100, false, hello)"));
  send("Play", {pcm_value(std::vector<Sample>(16)), 6});
  send("Stop", {});
  send("Stop", {7});
  EXPECT_THAT(host.take_events(), ElementsAre("Finished(6, 0, true, unknown)"));
  EXPECT_EQ(speaker.changes, 6);
}

TEST_F(PlayoutSpeakerTest, RefusesWhatItCannotDo) {
  send("Play", {"hello", 5});
  send("Play", {pcm_value({})});
  send("Mark", {5});
  EXPECT_THAT(host.take_events(),
              ElementsAre(HasSubstr("Failed(this is no audio"),
                          HasSubstr("Failed("), HasSubstr("Failed(")));
  EXPECT_EQ(speaker.changes, 0);
  speaker.is_gone = true;
  send("Finish", {5});
  EXPECT_THAT(host.take_events(), ElementsAre("Failed(the device is gone)"));
}

} // namespace
} // namespace parlour::adapters
