#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/tts/speech_job.hpp"
#include "tests/adapters/tts/fake_synthesizer.hpp"

namespace parlour::adapters::tts {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

// The calling thread is engine and plug-in.
class SpeechJobTest : public testing::Test {
protected:
  SpeechJob job(const std::string& text) {
    return {text, {1, 50}, {}, Milliseconds(1'000), [this] { ++woken; }};
  }

  int woken = 0;
  test::FakeSynthesizerState state;
  std::unique_ptr<Synthesizer> synthesizer =
      *test::make_fake_synthesizer(state);
};

TEST_F(SpeechJobTest, gives_words_before_the_frames_that_they_begin_in) {
  auto whole = job("one two");
  whole.speak_next(*synthesizer);
  const auto first = whole.take(100).spoken;
  ASSERT_THAT(first, SizeIs(6));
  EXPECT_EQ(std::get<SpokenWord>(first[0]).word, "one");
  const auto second = whole.take(200);
  EXPECT_EQ(std::get<SpokenWord>(second.spoken.at(0)).position, 100);
  EXPECT_TRUE(second.is_over);
}

TEST_F(SpeechJobTest, wakes_once_who_has_found_too_little) {
  auto whole = job("first. second. third.");
  const auto nothing = whole.take(200);
  EXPECT_THAT(nothing.spoken, IsEmpty());
  EXPECT_TRUE(nothing.will_wake);
  whole.speak_next(*synthesizer);
  EXPECT_EQ(woken, 1);
  EXPECT_TRUE(whole.take(200).will_wake);
  whole.speak_next(*synthesizer);
  EXPECT_EQ(woken, 2);
  EXPECT_FALSE(whole.take(190).will_wake);
  whole.speak_next(*synthesizer);
  EXPECT_EQ(woken, 2);
}

// What is ready might be all there is.
TEST_F(SpeechJobTest, is_ready_only_when_it_is_known_what_follows) {
  auto whole = job("first. second.");
  whole.speak_next(*synthesizer);
  EXPECT_TRUE(whole.take(100).will_wake);
  whole.speak_next(*synthesizer);
  EXPECT_EQ(woken, 1);
  EXPECT_TRUE(whole.take(200).is_over);
}

TEST_F(SpeechJobTest, stores_only_so_much) {
  auto whole = job(test::words(200)); // pieces of a second
  int pieces = 0;
  for (; whole.wants_more(); ++pieces)
    whole.speak_next(*synthesizer);
  EXPECT_EQ(pieces, 4);
  whole.take(1'000);
  EXPECT_TRUE(whole.wants_more());
}

TEST_F(SpeechJobTest, is_silent_after_it_was_cancelled) {
  auto whole = job("one. two.");
  whole.take(200);
  whole.cancel();
  whole.speak_next(*synthesizer);
  EXPECT_EQ(woken, 0);
  EXPECT_EQ(state.words_spoken(), 0);
  EXPECT_FALSE(whole.wants_more());
}

TEST_F(SpeechJobTest, ends_with_what_went_wrong) {
  auto failing = job("fail");
  failing.speak_next(*synthesizer);
  const auto portion = failing.take(200);
  EXPECT_EQ(portion.trouble, "it cannot say this");
  EXPECT_TRUE(portion.is_over);
}

} // namespace
} // namespace parlour::adapters::tts
