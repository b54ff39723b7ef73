#include <gtest/gtest.h>

#include "tests/tools/parlour/voice_test/fakes.hpp"
#include "tools/parlour/voice_test/background.hpp"

namespace parlour::tools {
namespace {

using Kind = NoiseWish::Kind;

TEST(Background, is_read_and_written) {
  EXPECT_EQ(read_noise("babble@20").value(), (NoiseWish{Kind::babble, 20}));
  EXPECT_EQ(read_noise("babble20").value(), (NoiseWish{Kind::babble, 20}));
  EXPECT_EQ(read_noise("pink@-2.5").value(), (NoiseWish{Kind::pink, -2.5}));
  EXPECT_EQ(read_noise("").value(), NoiseWish{});
  EXPECT_EQ(read_noise("none").value(), NoiseWish{});
  EXPECT_EQ(to_string(NoiseWish{Kind::white, 2.5}), "white@2.5");
  EXPECT_EQ(to_string(NoiseWish{}), "none");
}

TEST(Background, of_another_form_is_refused) {
  for (const auto* text :
       {"brown@20", "babble", "babble@", "babble@loud", "pink@100", "pink@1 "})
    EXPECT_FALSE(read_noise(text)) << text;
}

TEST(Background, is_so_much_weaker_than_the_speech) {
  SpeechBank bank(std::make_shared<test::HummingVoices>());
  for (const auto kind : {Kind::pink, Kind::white}) {
    const auto noise = make_noise({kind, 20}, "rms", bank);
    ASSERT_TRUE(noise);
    EXPECT_NEAR(adapters::level_of(*noise), SpeechBank::level - 20, 0.1);
  }
}

TEST(Background, may_be_silent) {
  SpeechBank bank(std::make_shared<test::HummingVoices>());
  EXPECT_TRUE(make_noise({}, "rms", bank)->empty());
}

TEST(Background, of_voices_says_which_one_is_missing) {
  SpeechBank bank(std::make_shared<test::HummingVoices>());
  const auto babble = make_noise({Kind::babble, 20}, "rms", bank);
  ASSERT_FALSE(babble);
  EXPECT_NE(babble.error().message.find("'awb'"), std::string::npos);
}

} // namespace
} // namespace parlour::tools
