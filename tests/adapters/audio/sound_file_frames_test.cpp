#include <gtest/gtest.h>

#include "adapters/audio/sound_file_frames.hpp"
#include "tests/adapters/audio/tones.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {
namespace {

class SoundFileFramesTest : public testing::Test {
protected:
  std::filesystem::path file(const std::vector<Sample>& samples,
                             const PcmFormat& format = {}) {
    const auto path = folder.path() / "a.wav";
    EXPECT_TRUE(SoundFileWriter::create(path, format)->write(samples));
    return path;
  }
  // The samples of up to `most` frames.
  static std::vector<Sample> take(SoundFileFrames& frames, int most = 1'000) {
    std::vector<Sample> all;
    std::vector<Sample> frame;
    for (; most > 0 && frames.next(frame); --most) {
      EXPECT_EQ(frame.size() % frame_samples, 0u);
      all.insert(all.end(), frame.begin(), frame.end());
    }
    return all;
  }

  test::TemporaryFolder folder;
};

TEST_F(SoundFileFramesTest, TheLastFrameEndsInSilence) {
  const auto tone = test::tone(400, 0.5, 1'000);
  auto frames = SoundFileFrames::open(file(tone), {}, {});
  ASSERT_TRUE(frames);
  auto expected = tone;
  expected.resize(1'280);
  EXPECT_EQ(take(*frames), expected);
  std::vector<Sample> frame;
  EXPECT_FALSE(frames->next(frame));
}

TEST_F(SoundFileFramesTest, SilenceFollows) {
  const auto tone = test::tone(400, 0.5, 1'000);
  auto frames =
      SoundFileFrames::open(file(tone), {}, {Milliseconds(100), false});
  auto expected = tone;
  expected.resize(2'880); // 2,600, to a whole frame
  EXPECT_EQ(take(*frames), expected);
}

TEST_F(SoundFileFramesTest, ComesAgain) {
  const auto tone = test::tone(400, 0.5, 320);
  auto frames = SoundFileFrames::open(file(tone), {}, {Milliseconds(20), true});
  auto expected = tone;
  expected.resize(640);
  for (int i = 0; i < 100; ++i)
    ASSERT_EQ(take(*frames, 2), expected) << i;
}

TEST_F(SoundFileFramesTest, BeginsAgainWhenAsked) {
  const auto tone = test::tone(400, 0.5, 48'000, 48'000);
  auto frames = SoundFileFrames::open(file(tone, {48'000, 1}), {}, {});
  const auto first = take(*frames);
  frames->rewind();
  take(*frames, 7);
  frames->rewind();
  EXPECT_EQ(take(*frames), first);
  EXPECT_NEAR(static_cast<double>(first.size()), speech_rate, 320);
}

TEST_F(SoundFileFramesTest, AnyFormatComesAsTheOneThatIsWanted) {
  std::vector<Sample> stereo;
  for (const auto sample : test::tone(500, 0.5, 44'100, 44'100))
    stereo.insert(stereo.end(), {sample, sample});
  auto frames = SoundFileFrames::open(file(stereo, {44'100, 2}), {}, {});
  ASSERT_TRUE(frames);
  const auto heard = take(*frames);
  EXPECT_NEAR(test::level_of(std::span(heard).first(15'680), 500), 0.5, 0.01);
}

TEST_F(SoundFileFramesTest, AnEmptyFileEndsAlthoughItIsLooped) {
  auto frames =
      SoundFileFrames::open(file({}), {}, {Milliseconds::zero(), true});
  ASSERT_TRUE(frames);
  std::vector<Sample> frame;
  EXPECT_FALSE(frames->next(frame));
}

} // namespace
} // namespace parlour::adapters
