#include <algorithm>
#include <random>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/vad/adaptive_detector.hpp"
#include "tests/support/audio/voices.hpp"

namespace parlour::adapters {
namespace {

using test::Sound;
using testing::ElementsAre;
using testing::IsEmpty;

struct Segment {
  std::int64_t begin = 0; // ms
  std::int64_t end = 0;
};

std::vector<SpeechEdge> edges_of(const Sound& sound) {
  AdaptiveDetector detector;
  return detector.take(sound);
}

std::vector<Segment> segments_of(const Sound& sound) {
  std::vector<Segment> segments;
  for (const auto& edge : edges_of(sound))
    if (edge.begins)
      segments.push_back({edge.position, duration(sound.size())});
    else
      segments.back().end = edge.position;
  return segments;
}

// Sentences with pauses of 0.9 to 2.4 s, and where they are.
struct Stream {
  Sound sound = test::silence(3'000);
  std::vector<Segment> sentences;

  void add(const Sound& sentence, std::int64_t pause) {
    const auto begin = duration(sound.size());
    sound.insert(sound.end(), sentence.begin(), sentence.end());
    sentences.push_back({begin, duration(sound.size())});
    const auto gap = test::silence(pause);
    sound.insert(sound.end(), gap.begin(), gap.end());
  }
};

Stream stream_of_bursts(std::uint64_t seed, int count) {
  std::mt19937_64 random(seed);
  Stream stream;
  for (int i = 0; i < count; ++i) {
    const auto length = 400 + static_cast<std::int64_t>(random() % 2'000);
    stream.add(test::speech_like(random(), length, -26),
               900 + static_cast<std::int64_t>(random() % 1'500));
  }
  return stream;
}

// What was found of the sentences.
struct Finding {
  int found = 0;
  int started_in_time = 0; // within 100 ms
  int merged = 0;
  int made_up = 0;
};

bool overlap(const Segment& one, const Segment& other) {
  return one.begin < other.end && other.begin < one.end;
}

Finding judge(const Stream& stream) {
  Finding finding;
  const auto segments = segments_of(stream.sound);
  for (const auto& sentence : stream.sentences) {
    const auto first = std::ranges::find_if(
        segments, [&](const auto& each) { return overlap(each, sentence); });
    if (first == segments.end())
      continue;
    ++finding.found;
    finding.started_in_time += std::abs(first->begin - sentence.begin) <= 100;
  }
  for (const auto& segment : segments) {
    const auto holds =
        std::ranges::count_if(stream.sentences, [&](const auto& each) {
          return overlap(each, segment);
        });
    finding.merged += holds > 1;
    finding.made_up += holds == 0;
  }
  return finding;
}

TEST(AdaptiveDetectorTest, FindsWhereSpeechIs) {
  auto sound = test::silence(1'000);
  const auto burst = test::speech_like(1, 600, -26);
  sound.insert(sound.end(), burst.begin(), burst.end());
  sound.resize(sound.size() + test::samples_in(1'000));
  const auto segments = segments_of(sound);
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_LE(std::abs(segments[0].begin - 1'000), 40);
  EXPECT_LE(std::abs(segments[0].end - 1'600), 60);
}

TEST(AdaptiveDetectorTest, FindsSpeechFromTheFirstFrameOn) {
  const auto segments = segments_of(test::speech_like(2, 1'000, -20));
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_EQ(segments[0].begin, 0);
}

TEST(AdaptiveDetectorTest, FindsEverySentenceInSilenceAndNoise) {
  const auto clean = stream_of_bursts(3, 40);
  EXPECT_EQ(judge(clean).found, 40);
  EXPECT_EQ(judge(clean).started_in_time, 40);
  EXPECT_EQ(judge(clean).merged, 0);
  EXPECT_EQ(judge(clean).made_up, 0);

  auto noisy = clean;
  test::add_noise(noisy.sound, test::pink_noise(4, 20'000, -30), 15, 5);
  EXPECT_EQ(judge(noisy).found, 40);
  EXPECT_GE(judge(noisy).started_in_time, 36);
  EXPECT_EQ(judge(noisy).merged, 0);
}

TEST(AdaptiveDetectorTest, MergesNoTurnsInBabble) {
  auto stream = stream_of_bursts(6, 60);
  const auto noise = test::can_speak()
                         ? test::babble(10, 30'000, -30)
                         : test::speech_like_babble(7, 30'000, -30, 8);
  test::add_noise(stream.sound, noise, 10, 8);
  const auto finding = judge(stream);
  EXPECT_EQ(finding.merged, 0);
  EXPECT_GE(finding.found, 59);
  EXPECT_GE(finding.started_in_time, 48);
}

// In a room with a ventilator, somebody speaks from 2,000 to 3,500 ms;
// meanwhile a crowd begins to talk and goes on to the end.
Sound speaker_before_crowd() {
  Sound sound = test::pink_noise(20, 8'000, -58);
  test::add(sound, test::speech_like(21, 1'500, -26), test::samples_in(2'000));
  test::add(sound, test::speech_like_babble(22, 5'000, -46, 8),
            test::samples_in(3'000));
  return sound;
}

TEST(AdaptiveDetectorTest, CrowdBehindIsNeitherATurnNorMakesOneLonger) {
  const auto segments = segments_of(speaker_before_crowd());
  ASSERT_EQ(segments.size(), 1u);
  EXPECT_LE(std::abs(segments[0].begin - 2'000), 60);
  EXPECT_LE(std::abs(segments[0].end - 3'500), 200);
}

TEST(AdaptiveDetectorTest, HearsWhoIsSofterThanTheOneBefore) {
  // At once in front of a crowd, and where it is quiet, much softer.
  auto crowded = speaker_before_crowd();
  test::add(crowded, test::speech_like(23, 600, -36), test::samples_in(5'000));
  EXPECT_EQ(segments_of(crowded).size(), 2u);
  auto quiet = test::silence(6'000);
  test::add(quiet, test::speech_like(24, 1'000, -20), test::samples_in(1'000));
  test::add(quiet, test::speech_like(25, 600, -44), test::samples_in(4'000));
  EXPECT_EQ(segments_of(quiet).size(), 2u);
}

// An hour of two noises that are repeated, in pieces that are no whole frames.
int turns_in_an_hour(const Sound& one, const Sound& other) {
  AdaptiveDetector detector;
  int turns = 0;
  constexpr std::size_t piece = 16'003;
  for (std::size_t at = 0; at < test::samples_in(3'600'000); at += piece)
    for (const auto& edge :
         detector.take(test::mixed_loops(one, other, at, piece)))
      turns += edge.begins;
  return turns;
}

TEST(AdaptiveDetectorTest, OpensHardlyAnyTurnInAnHourOfNoise) {
  EXPECT_LE(turns_in_an_hour(test::pink_noise(12, 61'003, -30),
                             test::tone(440, 67'000, -40)),
            6);
  EXPECT_EQ(turns_in_an_hour(test::silence(1'000), test::silence(1'000)), 0);
  if (test::can_speak()) {
    EXPECT_LE(turns_in_an_hour(test::babble(1, 31'000, -30),
                               test::babble(2, 37'000, -30)),
              6);
  }
}

TEST(AdaptiveDetectorTest, TakesNoKnockForSpeech) {
  auto sound = test::pink_noise(14, 6'000, -60);
  test::add(sound, test::tone(800, 60, -10), test::samples_in(3'000));
  EXPECT_THAT(segments_of(sound), IsEmpty());
  // And hears soft speech soon after it.
  test::add(sound, test::speech_like(15, 600, -36), test::samples_in(4'000));
  EXPECT_EQ(segments_of(sound).size(), 1u);
}

std::vector<SpeechEdge> heard_beside_echo(AdaptiveDetector& detector,
                                          const Sound& heard,
                                          const Sound& echo) {
  std::vector<SpeechEdge> found;
  for (std::size_t at = 0; at < heard.size(); at += frame_samples) {
    const auto size = std::min(frame_samples, heard.size() - at);
    detector.hear_echo(std::span(echo).subspan(at, size));
    for (const auto& edge : detector.take(std::span(heard).subspan(at, size)))
      found.push_back(edge);
  }
  return found;
}

TEST(AdaptiveDetectorTest, EchoRaisesTheThreshold) {
  const auto echo = test::speech_like(16, 2'000, -24);
  AdaptiveDetector detector;
  detector.take(test::silence(1'000));
  EXPECT_THAT(heard_beside_echo(detector, test::at_level(echo, -24, -40), echo),
              IsEmpty());
  // Somebody who speaks louder than that is heard.
  const auto edges =
      heard_beside_echo(detector, test::speech_like(17, 600, -20), echo);
  ASSERT_FALSE(edges.empty());
  EXPECT_LE(std::abs(edges[0].position - 3'000), 60);
}

TEST(AdaptiveDetectorTest, LoudRobotMakesNobodyUnheardAfterwards) {
  const auto echo = test::speech_like(26, 2'000, -6);
  const auto room = test::pink_noise(27, 3'000, -62);
  AdaptiveDetector detector;
  detector.take(room);
  EXPECT_THAT(heard_beside_echo(detector, test::at_level(echo, -6, -20), echo),
              IsEmpty());
  auto afterwards = room;
  test::add(afterwards, test::speech_like(28, 600, -40),
            test::samples_in(1'000));
  EXPECT_FALSE(detector.take(afterwards).empty());
}

TEST(AdaptiveDetectorTest, BelievesPositionsThatDoNotFollow) {
  AdaptiveDetector detector;
  detector.take(test::silence(1'000), 5'000);
  EXPECT_THAT(detector.take(test::speech_like(18, 500, -26), 6'000),
              ElementsAre(testing::Field(&SpeechEdge::begins, true)));
  // Two seconds are lost: the speech ended at the gap.
  const auto edges = detector.take(test::silence(100), 8'500);
  ASSERT_EQ(edges.size(), 1u);
  EXPECT_LE(std::abs(edges[0].position - 6'500), 60);
}

TEST(AdaptiveDetectorTest, DoesNotMindHowAudioIsCut) {
  const auto stream = stream_of_bursts(19, 5);
  AdaptiveDetector detector;
  std::vector<SpeechEdge> edges;
  for (std::size_t at = 0; at < stream.sound.size(); at += 137) {
    const auto size = std::min<std::size_t>(137, stream.sound.size() - at);
    for (const auto& edge :
         detector.take(std::span(stream.sound).subspan(at, size)))
      edges.push_back(edge);
  }
  EXPECT_EQ(edges, edges_of(stream.sound));
  detector.reset();
  EXPECT_EQ(detector.take(stream.sound), edges_of(stream.sound));
}

} // namespace
} // namespace parlour::adapters
