#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/sphinx/hearing.hpp"
#include "tests/adapters/asr/sphinx/small_application.hpp"

namespace parlour::adapters::asr {
namespace {

class HearingTest : public testing::Test {
protected:
  void SetUp() override {
    if (!SphinxDecoder::is_built_in() || !test::can_speak())
      GTEST_SKIP() << "built without PocketSphinx or flite";
    LanguageSources sources;
    sources.model = small_application();
    sources.columns = small_columns;
    sources.generic = platform_grammar("generic-acts.jsgf");
    sources.forms = platform_grammar("spoken-forms.jsgf");
    const auto made = make_vocabulary(sources, english_model);
    ASSERT_TRUE(made);
    auto heard =
        Hearing::make(std::make_shared<Vocabulary>(*made), english_model);
    ASSERT_TRUE(heard);
    hearing.emplace(std::move(*heard));
  }
  Heard hear(const test::Sound& sound,
             const std::vector<std::string>& grammars = {}) {
    EXPECT_TRUE(hearing->begin(grammars));
    hearing->hear(sound);
    return hearing->finish();
  }

  std::optional<Hearing> hearing;
};

TEST_F(HearingTest, BothWaysAgreeOnWhatBelongs) {
  for (const auto* const voice : {"rms", "slt"}) {
    const auto heard = hear(said("I would like lemon tea please.", voice));
    // Articles are weak: one more or less is heard easily.
    EXPECT_THAT(heard.by_grammar,
                testing::AnyOf("i would like lemon tea please",
                               "i would like the lemon tea please"))
        << voice;
    EXPECT_GE(heard.agreement, 0.8);
    EXPECT_EQ(heard.words.size(), heard.agreed.size());
    EXPECT_EQ(heard.words.back().word, "please");
  }
}

TEST_F(HearingTest, HearsNamesThatNoDictionaryHas) {
  EXPECT_EQ(hear(said("Call Arumugam Pillai.")).by_grammar,
            "call arumugam pillai");
}

// A rule of a few words can be heard in anything, so one of them may pass.
TEST_F(HearingTest, TheyDisagreeOnWhatDoesNotBelong) {
  int disagreed = 0;
  for (const auto* const foreign :
       {"My grandmother kept her buttons in a tin box.",
        "Silver dust covered the abandoned mine.",
        "Seven farmers painted their boats beside the river."})
    disagreed += hear(said(foreign)).agreement < 0.5 ? 1 : 0;
  EXPECT_GE(disagreed, 2);
}

// Where the grammar mishears it, too; the words alone may be a sentence by
// accident if they are few.
TEST_F(HearingTest, WordsThatAreASentenceCount) {
  const auto heard = hear(said("Bring me a coffee."));
  EXPECT_EQ(heard.by_domain, "bring me a coffee");
  EXPECT_GE(heard.agreement, 0.5);
}

// Whatever was said before, and how loud: the library goes by that.
TEST_F(HearingTest, GivesNoBeginningUp) {
  for (const auto* const before :
       {"Call Jeffery Ho.", "I would like lemon tea please.", "Yes."})
    for (const int loudness : {1, 3, 8}) {
      auto sound = said(before);
      for (auto& sample : sound)
        sample = static_cast<adapters::Sample>(sample / loudness);
      hear(sound);
      EXPECT_EQ(hear(said("Bring me a coffee.")).by_grammar,
                "bring me a coffee")
          << before << loudness;
    }
}

TEST_F(HearingTest, NarrowsToGrammars) {
  const auto heard = hear(said("Hot chocolate."), {"Order.Drink"});
  EXPECT_EQ(heard.by_grammar, "hot chocolate");
  // Of what belongs elsewhere, only what is generic can be heard.
  EXPECT_EQ(hear(said("Call Jeffery Ho."), {"Order.Drink"})
                .by_grammar.find("jeffery"),
            std::string::npos);
  EXPECT_EQ(hear(said("Call Jeffery Ho.")).by_grammar, "call jeffery ho");
}

TEST_F(HearingTest, TellsWhetherASentenceEnds) {
  ASSERT_TRUE(hearing->begin({}));
  EXPECT_EQ(hearing->ends("bring me"), false);
  EXPECT_EQ(hearing->ends("bring me coffee"), true);
  EXPECT_EQ(hearing->ends("coffee me bring"), std::nullopt);
  hearing->hear(said("Bring me a coffee."));
  EXPECT_EQ(hearing->partial(), "bring me a coffee");
  hearing->drop();
  EXPECT_TRUE(hearing->finish().words.empty());
}

} // namespace
} // namespace parlour::adapters::asr
