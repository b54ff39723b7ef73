#include <gtest/gtest.h>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {
namespace {

TEST(PcmTest, NamesAndReadsFormats) {
  EXPECT_EQ(format_name({}), "pcm_s16le;rate=16000;channels=1");
  EXPECT_EQ(parse_format("pcm_s16le;rate=44100;channels=2"),
            (PcmFormat{44'100, 2}));
  EXPECT_EQ(parse_format("pcm_s16le"), PcmFormat{});
  EXPECT_EQ(parse_format("pcm_s16le;channels=2"), (PcmFormat{16'000, 2}));
}

TEST(PcmTest, RefusesWhatIsNoFormat) {
  for (const auto* name :
       {"", "opus", "pcm_s16be;rate=16000", "pcm_s16le;rate=", "pcm_s16le;rate",
        "pcm_s16le;rate=3999", "pcm_s16le;rate=384001", "pcm_s16le;channels=0",
        "pcm_s16le;channels=33", "pcm_s16le;rate=16000x", "pcm_s16le;bits=8",
        "pcm_s16le;rate=99999999999999999999"})
    EXPECT_FALSE(parse_format(name)) << name;
}

TEST(PcmTest, SamplesComeBack) {
  const std::vector<Sample> samples = {0, 1, -1, 32'767, -32'768};
  const auto value = pcm_value(samples);
  const auto read = speech_samples(value);
  ASSERT_TRUE(read);
  EXPECT_EQ(std::vector<Sample>(read->begin(), read->end()), samples);
  const auto nothing = pcm_value({});
  EXPECT_TRUE(speech_samples(nothing)->empty());
}

TEST(PcmTest, RefusesWhatIsNoSpeech) {
  for (const Value& audio :
       {Value("hello"), pcm_value({}, {8'000, 1}), Value(Binary{"opus", {}})})
    EXPECT_FALSE(speech_samples(audio));
  const Binary one_byte{format_name({}), {std::byte{1}}};
  const auto half = speech_samples(one_byte);
  ASSERT_FALSE(half);
  EXPECT_NE(half.error().message.find("ends within a sample"),
            std::string::npos);
}

TEST(PcmTest, DurationIsInMilliseconds) {
  EXPECT_EQ(duration(frame_samples), frame_time);
  EXPECT_EQ(duration(44'100, 44'100), 1'000);
}

} // namespace
} // namespace parlour::adapters
