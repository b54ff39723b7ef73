#include <gmock/gmock.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/fix.hpp"

namespace parlour::tools {
namespace {

namespace fs = std::filesystem;

script::Finding edit(std::size_t begin, std::size_t end,
                     const std::string& text, const std::string& file = "") {
  script::Finding finding;
  finding.place = {file, 1, static_cast<std::uint32_t>(begin + 1)};
  finding.fix = {{{begin, end}, text}};
  return finding;
}

TEST(ApplyFixes, replaces_from_behind) {
  std::vector<script::Finding> fixed;
  EXPECT_EQ(
      apply_fixes("a = b = c", {edit(2, 3, "=="), edit(6, 7, "==")}, fixed),
      "a == b == c");
  EXPECT_EQ(fixed.size(), 2u);
}

TEST(ApplyFixes, makes_the_first_of_two_that_overlap) {
  std::vector<script::Finding> fixed;
  EXPECT_EQ(apply_fixes("abcd", {edit(0, 2, "x"), edit(1, 3, "y")}, fixed),
            "xcd");
  EXPECT_EQ(fixed.size(), 1u);
}

TEST(ApplyFixes, makes_all_edits_of_a_finding_or_none) {
  auto both = edit(0, 1, "x");
  both.fix.push_back({{3, 4}, "x"});
  std::vector<script::Finding> fixed;
  EXPECT_EQ(apply_fixes("abcd", {edit(3, 4, "y"), both}, fixed), "abcy");
  EXPECT_EQ(apply_fixes("abcd", {edit(9, 10, "y")}, fixed), "abcd");
}

TEST(FixFiles, changes_files_of_the_folder_only) {
  test::TemporaryFolder folder, other;
  folder.write("a.xml", "a = b");
  other.write("b.xml", "a = b");
  const auto result =
      fix_files({edit(2, 3, "==", (folder.path() / "a.xml").string()),
                 edit(2, 3, "==", (other.path() / "b.xml").string())},
                folder.path());
  ASSERT_TRUE(result);
  EXPECT_EQ(result->size(), 1u);
  EXPECT_EQ(folder.read("a.xml"), "a == b");
  EXPECT_EQ(other.read("b.xml"), "a = b");
}

TEST(ReplaceFile, keeps_permissions_and_links) {
  test::TemporaryFolder folder;
  folder.write("real.xml", "old");
  const auto real = folder.path() / "real.xml", link = folder.path() / "a.xml";
  fs::create_symlink("real.xml", link);
  fs::permissions(real, fs::perms::owner_read | fs::perms::owner_write |
                            fs::perms::group_read);
  ASSERT_TRUE(replace_file(link, "new"));
  EXPECT_EQ(folder.read("real.xml"), "new");
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(fs::status(real).permissions(), fs::perms::owner_read |
                                                fs::perms::owner_write |
                                                fs::perms::group_read);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);
}

TEST(ReplaceFile, leaves_what_it_cannot_write) {
  const auto result = replace_file("/dev/null/x", "new");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, testing::HasSubstr("it is as it was"));
}

} // namespace
} // namespace parlour::tools
