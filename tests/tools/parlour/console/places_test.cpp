#include <fstream>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

class PlacesTest : public testing::Test {
protected:
  PlacesTest() {
    for (const auto* name : {"work", "share"})
      std::filesystem::create_directories(root() / name);
    places_.working = root() / "work";
    places_.shares = {root() / "share"};
    places_.environment =
        [this](const char* name) -> std::optional<std::string> {
      const auto found = environment_.find(name);
      if (found == environment_.end())
        return std::nullopt;
      return found->second;
    };
  }

  std::filesystem::path root() const {
    return std::filesystem::canonical(folder_.path());
  }
  void make(const std::string& name) const {
    std::filesystem::create_directories(root() / name);
  }

  test::TemporaryFolder folder_;
  Places places_;
  std::map<std::string, std::string> environment_;
};

TEST_F(PlacesTest, finds_a_folder_by_its_path) {
  make("work/mine");
  EXPECT_EQ(find_application(places_, "mine").value(), root() / "work/mine");
  EXPECT_EQ(find_application(places_, "./mine/").value(), root() / "work/mine");
  EXPECT_EQ(find_application(places_, (root() / "work/mine").string()).value(),
            root() / "work/mine");
}

TEST_F(PlacesTest, tells_a_file_from_an_application) {
  make("work/mine");
  std::ofstream(root() / "work/mine/mine.xml") << "<dialogue/>";
  EXPECT_THAT(find_application(places_, "mine/mine.xml").error().message,
              HasSubstr("an application is a folder: mine"));
}

TEST_F(PlacesTest, prefers_the_working_folder_to_what_is_installed) {
  make("share/apps/desk");
  EXPECT_EQ(find_application(places_, "desk").value(),
            root() / "share/apps/desk");
  make("work/config/apps/desk");
  EXPECT_EQ(find_application(places_, "desk").value(),
            root() / "work/config/apps/desk");
}

TEST_F(PlacesTest, looks_for_a_path_nowhere_else) {
  make("share/apps/a/b");
  EXPECT_FALSE(find_application(places_, "a/b"));
}

TEST_F(PlacesTest, says_where_it_looked) {
  const auto found = find_application(places_, "nobody");
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message,
              HasSubstr("there is no application 'nobody'"));
  EXPECT_THAT(found.error().message, HasSubstr("work/config/apps/nobody"));
  EXPECT_THAT(found.error().message, HasSubstr("share/apps/nobody"));
  EXPECT_FALSE(find_application(places_, ""));
}

TEST_F(PlacesTest, takes_the_platform_beside_the_application) {
  make("share/platform");
  make("work/config/apps/desk");
  EXPECT_EQ(find_platform(places_, root() / "work/config/apps/desk"),
            root() / "share/platform");
  make("work/config/platform");
  EXPECT_EQ(find_platform(places_, root() / "work/config/apps/desk"),
            root() / "work/config/platform");
}

TEST_F(PlacesTest, keeps_data_where_the_environment_says) {
  environment_["HOME"] = "/home/ada";
  EXPECT_EQ(default_data_folder(places_, "/x/apps/desk"),
            "/home/ada/.local/share/parlour/desk");
  environment_["XDG_DATA_HOME"] = "/data";
  EXPECT_EQ(default_data_folder(places_, "/x/apps/desk"), "/data/parlour/desk");
  environment_["XDG_DATA_HOME"] = "relative";
  EXPECT_EQ(default_data_folder(places_, "/x/apps/desk"),
            "/home/ada/.local/share/parlour/desk");
}

TEST_F(PlacesTest, keeps_no_data_where_there_is_no_home) {
  EXPECT_THAT(default_data_folder(places_, "/x/apps/desk").error().message,
              HasSubstr("--data names a folder"));
  environment_["HOME"] = "relative";
  EXPECT_FALSE(default_data_folder(places_, "/x/apps/desk"));
}

TEST_F(PlacesTest, says_why_an_application_cannot_be_read) {
  std::filesystem::create_symlink("loop", root() / "work/loop");
  EXPECT_THAT(
      find_application(places_, "loop").error().message,
      testing::EndsWith("cannot be read: Too many levels of symbolic links"));
}

TEST_F(PlacesTest, shows_files_from_the_working_folder) {
  places_.working = "/site";
  EXPECT_EQ(shown_path(places_, "/site/app/a.xml:3"), "app/a.xml:3");
  EXPECT_EQ(shown_path(places_, "/sitemap/a.xml"), "/sitemap/a.xml");
  EXPECT_EQ(shown_path(places_, "a.xml"), "a.xml");
}

TEST(ProcessPlaces, finds_the_source_tree_of_a_program_not_installed) {
  const auto places = process_places();
  ASSERT_FALSE(places.shares.empty());
  EXPECT_EQ(places.shares[0], test::source_path("config"));
}

TEST_F(PlacesTest, looks_for_plugins_where_it_is_told_and_nowhere_else) {
  make("work/app/plugins");
  environment_["PARLOUR_PLUGINS"] = "/elsewhere";
  EXPECT_THAT(plugin_folders(places_, root() / "work/app"),
              testing::ElementsAre("/elsewhere"));
  places_.plugins = "here";
  EXPECT_THAT(plugin_folders(places_, root() / "work/app"),
              testing::ElementsAre(root() / "work/here"));
}

TEST_F(PlacesTest, looks_for_plugins_beside_the_application_and_installed) {
  places_.installed_plugins = root() / "lib";
  EXPECT_THAT(plugin_folders(places_, root() / "app"), testing::IsEmpty());
  make("app/plugins");
  make("lib");
  EXPECT_THAT(plugin_folders(places_, root() / "app"),
              testing::ElementsAre(root() / "app/plugins", root() / "lib"));
}

} // namespace
} // namespace parlour::tools
