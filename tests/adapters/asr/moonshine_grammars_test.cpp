#include <gmock/gmock.h>

#include "adapters/asr/moonshine_grammars.hpp"

namespace parlour::adapters::moonshine {
namespace {

using testing::Contains;
using testing::Not;

class MoonshineGrammarsTest : public testing::Test {
protected:
  static std::shared_ptr<const asr::MadeLanguage> language() {
    asr::LanguageSources sources;
    sources.model.topics.push_back(
        {"Visit", false, {{"Host", "query", {}, "db:staff.name"}}, {}});
    sources.model.grammars = {
        {"names", "public <meet> = i want to meet @db:staff.name;", {}},
        {"size", "public <size> = small | large;", {}}};
    sources.columns = [](const std::string&) {
      return Expected<std::vector<std::string>>({"Jeffery Ho", "Siti"});
    };
    sources.generic = {"generic", "public <yes> = yes;", {}};
    return std::make_shared<asr::MadeLanguage>(sources);
  }

  MoonshineGrammars grammars{language()};
};

TEST_F(MoonshineGrammarsTest, HaveTheirWordsAndValuesFirst) {
  const auto* names = grammars.words({"names"});
  ASSERT_TRUE(names);
  EXPECT_EQ(names->names, 2u);
  EXPECT_THAT(std::vector(names->phrases.begin(), names->phrases.begin() + 2),
              testing::UnorderedElementsAre("Jeffery Ho", "Siti"));
  EXPECT_THAT(names->phrases, Contains("meet"));
  EXPECT_THAT(names->phrases, Contains("Meet"));
  const auto* size = grammars.words({"size"});
  ASSERT_TRUE(size);
  EXPECT_EQ(size->names, 0u);
  EXPECT_THAT(size->phrases, Contains("large"));
  EXPECT_THAT(size->phrases, Contains("yes"));
  EXPECT_THAT(size->phrases, Not(Contains("meet")));
  EXPECT_FALSE(grammars.words({"nothing"}));
  EXPECT_FALSE(grammars.words({}));
}

TEST_F(MoonshineGrammarsTest, KnowWhereASentenceMayEnd) {
  EXPECT_EQ(grammars.ends({}, "I want to meet Jeffery Ho."), true);
  EXPECT_EQ(grammars.ends({}, "I want to meet"), false);
  EXPECT_EQ(grammars.ends({}, "Two foxes live here."), std::nullopt);
  EXPECT_EQ(grammars.ends({}, ""), std::nullopt);
  EXPECT_EQ(grammars.ends({"size"}, "Large."), true);
  EXPECT_EQ(grammars.ends({"size"}, "I want to"), std::nullopt);
}

TEST_F(MoonshineGrammarsTest, WriteNames) {
  EXPECT_EQ(grammars.typed("jeffery, at 10.30."), "Jeffery, at 10:30.");
}

TEST_F(MoonshineGrammarsTest, HaveADomainModel) {
  const auto model = grammars.domain_model();
  for (const auto* const word : {"\nwant\n", "\njeffery\n", "\n<s>\n"})
    EXPECT_THAT(model, testing::HasSubstr(word));
  const MoonshineGrammars none{
      std::make_shared<asr::MadeLanguage>(asr::LanguageSources{})};
  EXPECT_EQ(none.domain_model(), "");
}

} // namespace
} // namespace parlour::adapters::moonshine
