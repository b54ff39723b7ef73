#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/sphinx/keyword_search.hpp"
#include "tests/adapters/asr/sphinx/small_application.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::HasSubstr;

class KeywordSearchTest : public testing::Test {
protected:
  void SetUp() override {
    if (!SphinxDecoder::is_built_in() || !test::can_speak())
      GTEST_SKIP() << "built without PocketSphinx or flite";
  }
  void look_for(const std::vector<std::string>& phrases,
                double sensitivity = 0.5) {
    auto keywords = make_keywords(phrases, english_model, sensitivity);
    ASSERT_TRUE(keywords);
    auto made = KeywordSearch::make(std::make_shared<Keywords>(*keywords),
                                    english_model);
    ASSERT_TRUE(made);
    search.emplace(std::move(*made));
  }
  // The phrases found, in frames as a microphone gives them.
  std::vector<std::string> hear(test::Sound sound) {
    sound.resize(sound.size() + test::samples_in(500));
    std::vector<std::string> phrases;
    for (std::size_t at = 0; at < sound.size(); at += frame_samples)
      for (auto& found : search->hear(std::span(sound).subspan(
               at, std::min(frame_samples, sound.size() - at)))) {
        EXPECT_GE(found.confidence, 0.5);
        EXPECT_LE(found.confidence, 1);
        phrases.push_back(found.phrase);
      }
    return phrases;
  }

  std::optional<KeywordSearch> search;
};

TEST_F(KeywordSearchTest, FindsPhrasesWhereverTheyAreSaid) {
  look_for({"Hello, computer!", "hello robot"});
  for (const auto* const voice : {"rms", "slt"}) {
    EXPECT_THAT(hear(said("hello computer", voice)),
                testing::ElementsAre("Hello, computer!"))
        << voice;
    EXPECT_THAT(
        hear(said("Hello computer, turn on the light, hello computer.", voice)),
        testing::ElementsAre("Hello, computer!", "Hello, computer!"))
        << voice;
  }
}

TEST_F(KeywordSearchTest, FindsNothingInOtherSpeechAndNoise) {
  look_for({"hello robot", "computer"});
  EXPECT_THAT(hear(said("The train was late again so we played cards.")),
              testing::IsEmpty());
  EXPECT_THAT(hear(said("Hello, where is the coffee shop?", "slt")),
              testing::IsEmpty());
  EXPECT_THAT(hear(test::pink_noise(1, 5'000, -30)), testing::IsEmpty());
}

TEST_F(KeywordSearchTest, SensitivityMovesTheBar) {
  // Synthetic voices do not say it clearly.
  look_for({"hello robot"}, 0);
  EXPECT_THAT(hear(said("hello robot", "awb")), testing::IsEmpty());
  look_for({"hello robot"}, 1);
  EXPECT_THAT(hear(said("hello robot", "awb")),
              testing::ElementsAre("hello robot"));
}

TEST_F(KeywordSearchTest, SaysWhatIsWrong) {
  EXPECT_THAT(make_keywords({"hello"}, "/no/such/folder", 0.5).error().message,
              HasSubstr("pocketsphinx-en-us"));
  EXPECT_FALSE(make_keywords({"!"}, english_model, 0.5));
}

} // namespace
} // namespace parlour::adapters::asr
