#include <gtest/gtest.h>

#include "runtime/base/text/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour {
namespace {

namespace fs = std::filesystem;

TEST(Paths, BelowIsNotBesideAndNotTheFolderItself) {
  EXPECT_TRUE(is_below("/a/b/c", "/a/b"));
  EXPECT_TRUE(is_below("/a/b/c", "/a/b/"));
  EXPECT_FALSE(is_below("/a/b", "/a/b"));
  EXPECT_FALSE(is_below("/a/bc", "/a/b"));
  EXPECT_FALSE(is_below("/a", "/a/b"));
}

TEST(Paths, LinksAreFollowed) {
  test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "in");
  fs::create_symlink("..", folder.path() / "in" / "up");
  const auto inner = real_path(folder.path() / "in");
  EXPECT_FALSE(is_below(real_path(inner / "up" / "x"), inner));
  EXPECT_TRUE(is_below(real_path(inner / "not there" / "x"), inner));
}

} // namespace
} // namespace parlour
