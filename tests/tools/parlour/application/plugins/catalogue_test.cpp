#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/application/plugins/catalogue.hpp"

namespace parlour::tools {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

TEST(Catalogue, knows_plugins_by_one_name_each) {
  std::set<std::string> names;
  for (const auto& plugin : built_in_plugins()) {
    EXPECT_TRUE(names.insert(plugin.description.name).second);
    EXPECT_TRUE(plugin.create()) << plugin.description.name;
  }
  EXPECT_TRUE(names.count("SQLiteDatabase"));
  EXPECT_TRUE(names.count("PhraseNLG"));
  EXPECT_EQ(find_plugin("Nothing"), nullptr);
}

PluginFactory named(const std::string& name) {
  PluginFactory factory;
  factory.description.name = name;
  return factory;
}

class CatalogueTest : public testing::Test {
protected:
  test::TemporaryFolder first_;
  test::TemporaryFolder second_;
  const std::vector<PluginFactory> table_ = {named("Own")};
  Catalogue plugins_{{first_.path(), second_.path()}, table_};
};

TEST_F(CatalogueTest, names_all_once_the_program_s_own_first) {
  first_.write("Same.so", "");
  second_.write("Same.so", "");
  second_.write("Own.so", "");
  second_.write("Another.so", "");
  EXPECT_THAT(plugins_.names(), ElementsAre("Own", "Another", "Same"));
  EXPECT_EQ(plugins_.file_of("Same"), first_.path() / "Same.so");
  EXPECT_EQ(plugins_.file_of("Own"), "");
  EXPECT_TRUE(plugins_.has("Another"));
  EXPECT_FALSE(plugins_.has("Nothing"));
}

TEST_F(CatalogueTest, finds_the_program_s_own) {
  EXPECT_EQ(plugins_.find("Own")->description.name, "Own");
  EXPECT_EQ(plugins_.all().size(), 1u);
}

TEST_F(CatalogueTest, says_why_a_file_cannot_be_used) {
  first_.write("Text.so", "no library");
  const auto found = plugins_.find("Text");
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("Text.so cannot be used"));
  EXPECT_EQ(plugins_.all().size(), 1u);
}

TEST_F(CatalogueTest, names_the_nearest_or_where_it_looked) {
  first_.write("EchoTTS.so", "");
  EXPECT_EQ(plugins_.find("EchoTS").error().message,
            "there is no plug-in 'EchoTS', did you mean 'EchoTTS'?");
  EXPECT_EQ(plugins_.find("Whatever").error().message,
            "there is no plug-in 'Whatever', and no Whatever.so in " +
                first_.path().string() + ", " + second_.path().string());
}

} // namespace
} // namespace parlour::tools
