#include <gtest/gtest.h>

#include "adapters/vad/webrtc_detector.hpp"
#include "tests/support/audio/voices.hpp"

namespace parlour::adapters {
namespace {

TEST(WebRtcDetectorTest, FindsWhereSpeechIs) {
  const auto detector = make_webrtc_detector({});
  if (!detector || !test::can_speak())
    GTEST_SKIP() << "built without libwebrtc-audio-processing or flite";
  auto sound = test::silence(2'000);
  const auto speech = test::spoken("Is there a coffee shop here?");
  sound.insert(sound.end(), speech.begin(), speech.end());
  const auto end = duration(sound.size());
  sound.resize(sound.size() + test::samples_in(1'000));
  const auto edges = (*detector)->take(sound);
  ASSERT_EQ(edges.size(), 2u);
  EXPECT_LE(std::abs(edges[0].position - 2'000), 250);
  EXPECT_LE(std::abs(edges[1].position - end), 300);
  // From the beginning, it hears the same.
  (*detector)->reset();
  EXPECT_EQ((*detector)->take(sound), edges);
}

TEST(WebRtcDetectorTest, HearsNothingBelowTheEcho) {
  const auto detector = make_webrtc_detector({});
  if (!detector || !test::can_speak())
    GTEST_SKIP() << "built without libwebrtc-audio-processing or flite";
  const auto speech = test::spoken("Is there a coffee shop here?");
  for (std::size_t at = 0; at + frame_samples <= speech.size();
       at += frame_samples) {
    (*detector)->hear_echo(test::tone(500, 20, -3));
    EXPECT_TRUE((*detector)
                    ->take(std::span(speech).subspan(at, frame_samples))
                    .empty());
  }
}

} // namespace
} // namespace parlour::adapters
