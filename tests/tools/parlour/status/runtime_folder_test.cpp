#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/status/runtime_folder.hpp"

namespace parlour::tools {
namespace {

namespace fs = std::filesystem;

Places places(std::optional<std::string> runtime) {
  Places made;
  made.environment = [=](const char* name) -> std::optional<std::string> {
    return std::string(name) == "XDG_RUNTIME_DIR" ? runtime : std::nullopt;
  };
  return made;
}

TEST(RuntimeFolder, IsTheUsersOwn) {
  EXPECT_EQ(runtime_folder(places("/run/user/7")), "/run/user/7/parlour");
  const auto name = "parlour-" + std::to_string(getuid());
  for (const auto& no_folder :
       {std::optional<std::string>(), std::optional<std::string>("here")})
    EXPECT_EQ(runtime_folder(places(no_folder)).filename(), name);
}

TEST(RuntimeFolder, IsMadeForNobodyElse) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "parlour";
  EXPECT_TRUE(make_runtime_folder(path));
  EXPECT_TRUE(make_runtime_folder(path)); // it is there
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_all);
}

TEST(RuntimeFolder, IsRefusedWhereOthersReachIt) {
  test::TemporaryFolder folder;
  const auto path = folder.path() / "open";
  fs::create_directory(path);
  fs::permissions(path, fs::perms::owner_all | fs::perms::others_exec);
  EXPECT_FALSE(make_runtime_folder(path));
  const auto link = folder.path() / "link";
  fs::create_symlink(folder.path(), link);
  EXPECT_FALSE(make_runtime_folder(link));
  EXPECT_FALSE(make_runtime_folder(folder.path() / "nowhere" / "parlour"));
}

} // namespace
} // namespace parlour::tools
