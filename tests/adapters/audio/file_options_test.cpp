#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/file_options.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

class FileOptionsTest : public testing::Test {
protected:
  std::string mistake(const Options& given) {
    OptionReader read(given, described);
    options = read_file_options(read, {}, "/data");
    const auto outcome = read.outcome();
    return outcome ? "none" : outcome.error().message;
  }

  const std::vector<OptionDescription> described{
      {"file", "sound.wav", ""},
      pace_option("it is heard"),
      {"silence", "2s", "", false, OptionType::duration}};
  FileOptions options{{}, Pace::of_clock()};
};

TEST_F(FileOptionsTest, AreReadWithTheirDefaults) {
  EXPECT_EQ(mistake({}), "none");
  EXPECT_EQ(options.file, "/data/sound.wav");
  EXPECT_EQ(options.silence, Milliseconds(2'000));
  EXPECT_EQ(options.pace.sound_in(Milliseconds(5)), Milliseconds(5));
  EXPECT_EQ(mistake({{"pace", "10"}, {"silence", "1h"}}), "none");
  EXPECT_EQ(options.silence, Milliseconds(3'600'000));
  EXPECT_EQ(options.pace.sound_in(Milliseconds(5)), Milliseconds(50));
}

TEST_F(FileOptionsTest, YieldToTheCommandLine) {
  const Options given{{"file", "../x"}};
  OptionReader read(given, described);
  EXPECT_EQ(read_file_options(read, "/home/a.wav", "/data").file,
            "/home/a.wav");
  EXPECT_TRUE(read.outcome());
}

TEST_F(FileOptionsTest, SayWhatIsWrong) {
  EXPECT_THAT(mistake({{"file", "../x"}}), HasSubstr("file"));
  EXPECT_THAT(mistake({{"pace", "17"}}), HasSubstr("'pace'"));
  for (const auto* text : {"61m", "long"})
    EXPECT_THAT(mistake({{"silence", text}}), HasSubstr("'silence'")) << text;
}

} // namespace
} // namespace parlour::adapters
