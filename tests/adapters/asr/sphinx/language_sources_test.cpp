#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/asr/sphinx/language_sources.hpp"
#include "tests/adapters/asr/sphinx/small_application.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::asr {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LanguageSourcesTest, ComeFromHostApplicationAndPlatform) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "dialogues");
  std::ofstream(folder.path() / "dialogues" / "a.txt") << "U: Hello.\n";
  test::FakePluginHost host;
  host.application = folder.path().string();
  host.model = std::make_shared<UnderstandingModel>(small_application());
  host.columns = small_columns;
  const auto sources = language_sources(
      host, {{"platform", test::source_path("config/platform")}});
  ASSERT_TRUE(sources);
  EXPECT_EQ(sources->model.grammars.size(), 1u);
  EXPECT_TRUE(sources->generic && sources->forms);
  EXPECT_THAT(sources->conversations.lines, ElementsAre("Hello."));
  EXPECT_TRUE(sources->columns("db:guests.name"));
  EXPECT_FALSE(language_sources(host, {{"conversations", "../elsewhere"}}));
}

TEST(LanguageSourcesTest, DoWithoutThem) {
  const test::FakePluginHost host;
  const auto sources = language_sources(host, {});
  ASSERT_TRUE(sources);
  EXPECT_FALSE(sources->generic);
  EXPECT_THAT(sources->conversations.lines, IsEmpty());
}

} // namespace
} // namespace parlour::adapters::asr
