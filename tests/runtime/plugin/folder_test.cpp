#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/folder.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Inside, GivesWhatIsBelowItsFolder) {
  test::TemporaryFolder folder;
  const auto& path = folder.path();
  EXPECT_EQ(inside(path, "a.db", "file").value(), path / "a.db");
  EXPECT_EQ(inside(path, "sql/../a b/c.sql", "file").value(),
            path / "a b/c.sql");
  EXPECT_EQ(inside(path / "", "..a", "file").value(), path / "..a");
}

TEST(Inside, RefusesWhatLeavesIt) {
  test::TemporaryFolder folder;
  folder.write("inner/a", "");
  const auto inner = folder.path() / "inner";
  std::filesystem::create_directory_symlink(folder.path(), inner / "up");
  for (const std::string name :
       {"", ".", "..", "../a", "x/../../a", "/etc/a", "up/a", "../inner2/a"}) {
    const auto found = inside(inner, name, "seed");
    ASSERT_FALSE(found) << name;
    EXPECT_EQ(found.error().kind, ErrorKind::settings);
    EXPECT_THAT(found.error().message,
                AllOf(HasSubstr("option 'seed'"), HasSubstr(name),
                      HasSubstr(inner.string())));
  }
}

} // namespace
} // namespace parlour
