#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/words/language.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class LanguageTest : public testing::Test {
protected:
  LanguageTest() {
    sources.model.topics.push_back(
        {"Order",
         false,
         {{"Drink", "set", {"tea", "iced Lemon tea"}, "", false, false},
          {"Barista", "", {}, "db:staff.name", false, false},
          {"Guest", "", {}, "", false, false}},
         {"I am [Anna Vanderbilt](Guest)"}});
    sources.model.grammars.push_back(
        {"order",
         "public <order> = (i want | bring me) @Order.Drink [please];\n"
         "public <call> = call @db:staff.name;\n"
         "public <guest> = my name is @words {Guest};\n"
         "public <when> = at @time;\n"
         "<unused> = nobody says this;",
         {}});
    sources.columns =
        [](const std::string& name) -> Expected<std::vector<std::string>> {
      if (name != "db:staff.name")
        return fail(ErrorKind::database, "no such column");
      return std::vector<std::string>{"Ya Kun", "Siti"};
    };
    sources.generic = {"generic", "public <yes> = yes | i do;", {}};
    sources.forms = {"forms", "public <time> = (nine | ten) [am] | noon;", {}};
    read_conversation("U: What's up?\nR: nothing\nU(voice=rms): two teas\n"
                      "expect slot Order.Guest = Bob\n",
                      sources.conversations);
  }
  static std::optional<bool> ends(const Language& language,
                                  std::vector<std::string> words) {
    return language.ends(language.sentences(), words);
  }

  LanguageSources sources;
};

TEST_F(LanguageTest, HasTheSentencesOfGrammarsAndValues) {
  const Language language(sources);
  EXPECT_EQ(ends(language, {"i", "want", "iced", "lemon", "tea"}), true);
  EXPECT_EQ(ends(language, {"i", "want", "iced", "lemon"}), false);
  EXPECT_EQ(ends(language, {"bring", "me", "tea", "please", "yes"}), true);
  EXPECT_EQ(ends(language, {"call", "ya", "kun"}), true);
  EXPECT_EQ(ends(language, {"call", "ya"}), false);
  EXPECT_EQ(ends(language, {"at", "nine", "a.m."}), true);
  EXPECT_EQ(ends(language, {"siti"}), true);
  EXPECT_EQ(ends(language, {"nobody"}), std::nullopt);
  EXPECT_EQ(ends(language, {}), std::nullopt);
}

TEST_F(LanguageTest, HasWhatExamplesAndConversationsSay) {
  const Language language(sources);
  EXPECT_EQ(ends(language, {"i", "am", "anna", "vanderbilt"}), true);
  EXPECT_EQ(ends(language, {"i'm", "bob"}), true);
  EXPECT_EQ(ends(language, {"my", "name", "is", "bob"}), true);
  EXPECT_EQ(ends(language, {"two", "teas"}), true);
  EXPECT_EQ(ends(language, {"nothing"}), std::nullopt);
}

TEST_F(LanguageTest, KnowsWordingsOnlyInItsDomainModel) {
  sources.wordings = {{"Order", {}, "fetch us [tea](Drink) pronto"},
                      {"Order", {}, "it is for [Zelda](Guest)"},
                      {"Elsewhere", {}, "forget it"}};
  const Language language(sources);
  const auto arpa = Trigrams(language.counts(200)).arpa(language.symbols());
  EXPECT_THAT(arpa, HasSubstr(" fetch us"));
  EXPECT_THAT(arpa, testing::AnyOf(HasSubstr(" us tea pronto"),
                                   HasSubstr(" lemon tea pronto")));
  EXPECT_THAT(arpa, HasSubstr(" is for"));
  EXPECT_THAT(arpa, Not(HasSubstr("forget")));
  EXPECT_EQ(ends(language, {"fetch", "us", "tea", "pronto"}), std::nullopt);
}

TEST_F(LanguageTest, LetsDeterminersStandBeforeValues) {
  const Language language(sources);
  EXPECT_EQ(ends(language, {"i", "want", "a", "tea"}), true);
  EXPECT_EQ(ends(language, {"i", "want", "an"}), false);
}

TEST_F(LanguageTest, NarrowsToGrammarsRulesAndSlots) {
  const Language language(sources);
  const auto drinks = language.sentences({"Order.Drink"});
  ASSERT_TRUE(drinks);
  EXPECT_EQ(language.ends(*drinks, {"tea"}), true);
  EXPECT_EQ(language.ends(*drinks, {"yes"}), true);
  EXPECT_EQ(language.ends(*drinks, {"siti"}), std::nullopt);
  EXPECT_TRUE(language.sentences({"time"}));
  EXPECT_TRUE(language.sentences({"order"}));
  EXPECT_FALSE(language.sentences({"no such"}));
}

TEST_F(LanguageTest, TellsValuesAndWordsOfSentences) {
  const Language language(sources);
  const auto order = language.phrases(*language.sentences({"order"}), 100);
  EXPECT_THAT(order.values, Contains("iced Lemon tea"));
  EXPECT_THAT(order.values, Contains("Ya Kun"));
  EXPECT_THAT(order.words, Contains("bring"));
  EXPECT_THAT(order.words, Contains("yes"));
  EXPECT_EQ(language.phrases(*language.sentences({"order"}), 1).values.size(),
            1u);
  const auto time = language.phrases(*language.sentences({"time"}), 100);
  EXPECT_TRUE(time.values.empty());
}

TEST_F(LanguageTest, IsWrittenForTheRecogniser) {
  const Language language(sources);
  const auto fsg = language.fsg(language.sentences()).text;
  EXPECT_THAT(fsg, HasSubstr("FSG_BEGIN"));
  EXPECT_THAT(fsg, HasSubstr(" lemon\n"));
  const auto arpa = Trigrams(language.counts(200)).arpa(language.symbols());
  EXPECT_THAT(arpa, HasSubstr(" ya kun"));
  EXPECT_THAT(arpa, HasSubstr(" two teas"));
  EXPECT_THAT(arpa, Not(HasSubstr("nobody")));
  EXPECT_THAT(language.words(), Contains("lemon"));
}

TEST_F(LanguageTest, SpellsWordsAsTheApplicationDoes) {
  const Language language(sources);
  EXPECT_EQ(language.written("siti"), "Siti");
  EXPECT_EQ(language.written("i"), "I");
  EXPECT_EQ(language.written("i'm"), "I'm");
  EXPECT_EQ(language.written("a.m."), "am");
  EXPECT_EQ(language.written("tea"), "tea");
}

TEST_F(LanguageTest, DoesWithoutWhatIsMissing) {
  sources.columns = nullptr;
  sources.forms.reset();
  sources.model.grammars.push_back(
      {"wrong", "public <loop> = a <loop>; public <lost> = <nothing> b", {}});
  const Language language(sources);
  EXPECT_EQ(ends(language, {"i", "want", "tea"}), true);
  const Language nothing{LanguageSources()};
  EXPECT_EQ(ends(nothing, {"yes"}), std::nullopt);
  EXPECT_THAT(nothing.fsg(nothing.sentences()).text, HasSubstr("FSG_END"));
}

} // namespace
} // namespace parlour::adapters::asr
