#include <gmock/gmock.h>

#include "adapters/asr/words/language_store.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::HasSubstr;

class LanguageStoreTest : public testing::Test {
protected:
  LanguageStoreTest() {
    sources_.model.topics.push_back(
        {"Visit", false, {{"Host", "query", {}, "db:staff.name"}}, {}});
    sources_.model.grammars = {
        {"names", "public <meet> = i want to meet @db:staff.name;", {}}};
    sources_.columns = [this](const std::string&) { return staff_; };
  }

  std::shared_ptr<const MadeLanguage> get() {
    return store_.get(sources_);
  }

  Expected<std::vector<std::string>> staff_{{"Jeffery Ho", "Siti"}};
  LanguageSources sources_;
  LanguageStore store_;
};

TEST_F(LanguageStoreTest, has_the_one_that_was_made) {
  const auto first = get();
  EXPECT_THAT(first->arpa(), HasSubstr("jeffery ho"));
  EXPECT_EQ(first, get());
}

TEST_F(LanguageStoreTest, tells_languages_apart_by_all_that_they_are_made_of) {
  auto before = get();
  const auto is_another = [&](const char* word) {
    const auto made = get();
    EXPECT_THAT(made->arpa(), HasSubstr(word));
    return made != std::exchange(before, made);
  };
  staff_ = std::vector<std::string>{"Zelda Quill"};
  EXPECT_TRUE(is_another("zelda quill"));
  sources_.model.grammars[0].text = "public <tea> = tea for @db:staff.name;";
  EXPECT_TRUE(is_another("tea for"));
  sources_.generic = GrammarModel{"generic", "public <yes> = certainly;", {}};
  EXPECT_TRUE(is_another("certainly"));
  sources_.forms = GrammarModel{"forms", "public <date> = tomorrow;", {}};
  EXPECT_TRUE(is_another("tea for"));
  sources_.conversations.lines = {"good heavens"};
  EXPECT_TRUE(is_another("good heavens"));
  sources_.wordings = {{"Visit", {}, "let me see the boss"}};
  EXPECT_TRUE(is_another("the boss"));
}

TEST_F(LanguageStoreTest, makes_it_anew_once_a_column_can_be_read) {
  staff_ = fail(ErrorKind::database, "no table");
  const auto without = get();
  EXPECT_EQ(without, get());
  staff_ = std::vector<std::string>{"Siti"};
  EXPECT_THAT(get()->arpa(), HasSubstr("siti"));
}

TEST_F(LanguageStoreTest, needs_neither_sentences_nor_a_database) {
  EXPECT_EQ(store_.get({})->arpa(), "");
  EXPECT_EQ(store_.get({})->packed_model(), "");
  sources_.columns = nullptr;
  sources_.model.grammars[0].text = "public <tea> = some tea please;";
  EXPECT_THAT(get()->arpa(), HasSubstr("some tea please"));
}

} // namespace
} // namespace parlour::adapters::asr
