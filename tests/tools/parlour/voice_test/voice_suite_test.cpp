#include "tests/tools/parlour/voice_test/spoken_application.hpp"
#include "tools/parlour/voice_test/voice_suite.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;

class VoiceSuiteTest : public SpokenTest {
protected:
  // Each row by itself, whatever became of the one before.
  VoiceResult hold(const std::string& text) {
    TestSuite suite;
    suite.conversations.push_back(conversation(text));
    auto results = hold_by_voices(typed, spoken, suite, {{"rms"}, {}, false, 1},
                                  std::make_shared<test::HummingVoices>());
    EXPECT_TRUE(results);
    return results->at(0);
  }
};

TEST_F(VoiceSuiteTest, goes_on_behind_what_went_wrong) {
  *hears = {"won", "two", "tree"};
  const auto result = hold("U: one\nR~ .*\nU: two\nR~ .*\nU: three\nR~ .*\n");
  EXPECT_EQ(result.trouble, "");
  ASSERT_EQ(result.found.size(), 3u);
  EXPECT_THAT(result.found[0].heard, ElementsAre("won"));
  EXPECT_THAT(result.found[1].heard, ElementsAre("two"));
  EXPECT_THAT(result.found[2].heard, ElementsAre("tree"));

  const auto score = score_of({result}, "rms");
  EXPECT_EQ(score.words, (WordErrors{3, 2, 0, 0}));
  EXPECT_EQ(score.rows, 3u);
  EXPECT_EQ(score.right, 3u); // there is no understanding
  EXPECT_EQ(score.answered, 1u);
  EXPECT_EQ(score.latencies.size(), 3u);
  EXPECT_EQ(score_of({result}, "slt").rows, 0u);
}

TEST_F(VoiceSuiteTest, leaves_out_what_cannot_be_spoken) {
  const auto result = hold("U: one\nR~ .*\nB: two\n");
  EXPECT_NE(result.trouble, "");
  EXPECT_TRUE(result.found.empty());
}

TEST(VoiceScore, has_percentiles) {
  std::vector<Latency> sorted;
  for (int i = 1; i <= 100; ++i)
    sorted.push_back({Milliseconds(i), 0ms, 0ms});
  EXPECT_EQ(percentile(sorted, 50), 51ms);
  EXPECT_EQ(percentile(sorted, 95), 95ms);
  EXPECT_EQ(percentile({sorted[6]}, 95), 7ms);
  EXPECT_EQ(percentile({}, 95), 0ms);
}

} // namespace
} // namespace parlour::tools
