#include <gtest/gtest.h>

#include "adapters/audio/utterance.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

using Samples = std::vector<Sample>;

class UtteranceTest : public testing::Test {
protected:
  void append(Samples samples) {
    const auto audio = pcm_value(samples);
    utterance.append(audio, *speech_samples(audio));
  }
  Samples take(std::size_t count) {
    Samples out(count);
    out.resize(utterance.take(out));
    return out;
  }

  Utterance utterance{test::message("Play"), 4};
};

TEST_F(UtteranceTest, PiecesBecomeOneStream) {
  append({1, 2, 3});
  append({});
  append({4, 5});
  EXPECT_EQ(take(2), (Samples{1, 2}));
  EXPECT_EQ(take(2), (Samples{3, 4}));
  EXPECT_EQ(utterance.waiting(), 1u);
  EXPECT_EQ(take(9), (Samples{5}));
  EXPECT_EQ(utterance.taken(), 5u);
  EXPECT_FALSE(utterance.is_over());
  utterance.finish(test::message("Finish"));
  EXPECT_TRUE(utterance.is_over());
  EXPECT_EQ(utterance.order().command, "Finish");
}

TEST_F(UtteranceTest, IsKnownByItsSessionAndNumber) {
  EXPECT_TRUE(utterance.is("s1", 4));
  EXPECT_FALSE(utterance.is("s2", 4));
  EXPECT_FALSE(utterance.is("s1", 5));
}

TEST_F(UtteranceTest, FadesEvenly) {
  append(Samples(2'000, 10'000));
  take(100);
  utterance.stop();
  const auto faded = take(2'000);
  ASSERT_EQ(faded.size(), Utterance::fade_samples);
  EXPECT_EQ(faded.front(), 10'000);
  for (std::size_t i = 1; i < faded.size(); ++i) {
    EXPECT_LE(faded[i], faded[i - 1]);
    EXPECT_GT(faded[i], faded[i - 1] - 40); // a step of 31 each
  }
  EXPECT_LT(faded.back(), 40);
  EXPECT_TRUE(utterance.is_over());
}

TEST_F(UtteranceTest, StopsAtOnceIfItHasNotBegun) {
  append(Samples(2'000, 10'000));
  utterance.stop();
  EXPECT_TRUE(utterance.is_over());
  EXPECT_TRUE(take(5).empty());
}

TEST_F(UtteranceTest, ASecondStopDoesNotFadeAnew) {
  append(Samples(2'000, 10'000));
  take(100);
  utterance.stop();
  take(300);
  utterance.stop();
  EXPECT_EQ(take(300).size(), 20u);
}

TEST_F(UtteranceTest, WordsCountOnceTheirEndWasHeard) {
  append(Samples(1'600)); // 100 ms
  EXPECT_EQ(utterance.spoken_text(0), Value());
  utterance.mark("three", 60);
  utterance.mark("one", 0);
  utterance.mark("two", 30);
  EXPECT_EQ(utterance.spoken_text(0), Value(""));
  EXPECT_EQ(utterance.spoken_text(16 * 29), Value(""));
  EXPECT_EQ(utterance.spoken_text(16 * 30), Value("one"));
  EXPECT_EQ(utterance.spoken_text(16 * 60), Value("one two"));
  take(1'600);
  EXPECT_EQ(utterance.spoken_text(1'600), Value("one two"));
  utterance.finish(test::message("Finish"));
  EXPECT_EQ(utterance.spoken_text(1'600), Value("one two three"));
  EXPECT_EQ(utterance.spoken_text(1'599), Value("one two"));
}

} // namespace
} // namespace parlour::adapters
