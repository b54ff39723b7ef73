#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/tts/utterance_queue.hpp"
#include "tests/adapters/tts/fake_synthesizer.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters::tts {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class UtteranceQueueTest : public testing::Test {
protected:
  void add(std::int64_t id, int words) {
    queue->add({{}, id, test::words(words), {}});
  }

  test::FakeSynthesizerState state;
  SharedEngine shared{[this] { return test::make_fake_synthesizer(state); }};
  std::shared_ptr<SpeechEngine> engine = *shared.use();
  test::FakePluginHost host;
  int frames = 0;
  int marks = 0;
  std::vector<std::int64_t> finished;
  SpeechCalls calls{
      [this](const Utterance&, const Value&) { ++frames; },
      [this](const Utterance&, const SpokenWord&) { ++marks; },
      [this](const Utterance& one) { finished.push_back(one.id); },
      [](const Utterance&, const std::string&) {}};
  std::shared_ptr<UtteranceQueue> queue = std::make_shared<UtteranceQueue>(
      host, *engine, Pace{Milliseconds(400), true}, calls);
};

TEST_F(UtteranceQueueTest, delivers_as_time_goes_on) {
  add(1, 10); // a second
  EXPECT_EQ(frames, 20);
  EXPECT_EQ(marks, 4);
  host.advance(Milliseconds(100));
  EXPECT_EQ(frames, 25);
  host.advance(Milliseconds(500));
  EXPECT_EQ(frames, 50);
  EXPECT_THAT(finished, ElementsAre(1));
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(UtteranceQueueTest, speaks_one_after_the_other) {
  add(1, 5);
  add(2, 5);
  EXPECT_EQ(frames, 20);
  EXPECT_EQ(queue->size(), 2u);
  host.advance(Milliseconds(100));
  EXPECT_THAT(finished, ElementsAre(1));
  EXPECT_EQ(frames, 45);
  queue->stop(2);
  EXPECT_THAT(finished, ElementsAre(1, 2));
  EXPECT_EQ(host.pending(), 0u);
}

TEST_F(UtteranceQueueTest, tells_nothing_after_its_end) {
  add(1, 10);
  queue.reset();
  EXPECT_EQ(host.pending(), 0u);
  EXPECT_THAT(finished, IsEmpty());
}

} // namespace
} // namespace parlour::adapters::tts
