#include <gmock/gmock.h>

#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/application/fix.hpp"

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

script::Finding broken(const std::string& file) {
  script::Finding finding;
  finding.place.file = file;
  finding.name = "xml";
  return finding;
}

// Reports every '=' that stands alone, and as many '!' as `worse` says.
std::vector<script::Finding> finds(const std::string& file,
                                   const std::string& text) {
  std::vector<script::Finding> all;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '=')
      all.push_back(edit(at, at + 1, "~", file));
    if (text[at] == '#')
      all.push_back(edit(at, at + 1, "!", file));
    for (int i = 0; text[at] == '!' && i < 3; ++i)
      all.push_back(broken(file));
  }
  return all;
}

Corrected corrected(test::TemporaryFolder& folder, const std::string& text) {
  folder.write("a.xml", text);
  const auto file = (folder.path() / "a.xml").string();
  const auto check = [&](const script::SourceTexts& texts) {
    return finds(file, texts.at(file));
  };
  return correct(finds(file, text), check, folder.path());
}

TEST(IsWorse, counts_errors_findings_and_broken_files) {
  auto warning = edit(0, 1, "");
  warning.severity = script::Severity::warning;
  const auto error = edit(0, 1, "");
  EXPECT_FALSE(is_worse({}, {}));
  EXPECT_FALSE(is_worse({warning}, {error}));
  EXPECT_TRUE(is_worse({error}, {warning, warning}));
  EXPECT_TRUE(is_worse({warning, warning}, {warning}));
  EXPECT_FALSE(is_worse({warning, warning}, {error})); // the error hid them
  EXPECT_TRUE(is_worse({broken("a")}, {error, broken("b")}));
  EXPECT_FALSE(is_worse({broken("a")}, {broken("a"), error}));
}

TEST(Correct, keeps_what_is_good_of_what_would_harm) {
  test::TemporaryFolder folder;
  const auto result = corrected(folder, "a = b # c = d # e = f");
  ASSERT_EQ(result.texts.size(), 1u);
  EXPECT_EQ(result.texts.begin()->second, "a ~ b # c ~ d # e ~ f");
  EXPECT_EQ(result.made.size(), 3u);
  EXPECT_EQ(result.findings.size(), 2u);
  EXPECT_EQ(folder.read("a.xml"), "a = b # c = d # e = f");
}

TEST(Correct, leaves_alone_what_only_harms) {
  test::TemporaryFolder folder;
  const auto result = corrected(folder, "# #");
  EXPECT_TRUE(result.texts.empty());
  EXPECT_TRUE(result.made.empty());
  EXPECT_EQ(result.findings.size(), 2u);
}

TEST(Correct, goes_on_with_what_a_correction_shows) {
  test::TemporaryFolder folder;
  folder.write("a.xml", "#");
  const auto file = (folder.path() / "a.xml").string();
  const auto find = [&](const std::string& text) {
    std::vector<script::Finding> all;
    for (std::size_t at = 0; at < text.size(); ++at)
      if (text[at] != '.')
        all.push_back(edit(at, at + 1, text[at] == '#' ? "==" : ".", file));
    return all;
  };
  const auto result = correct(
      find("#"), [&](const auto& texts) { return find(texts.at(file)); },
      folder.path());
  ASSERT_EQ(result.texts.size(), 1u);
  EXPECT_EQ(result.texts.begin()->second, "..");
}

TEST(Correct, changes_files_of_the_folder_only) {
  test::TemporaryFolder folder, other;
  folder.write("a.xml", "a = b");
  other.write("b.xml", "a = b");
  const auto inside = (folder.path() / "a.xml").string(),
             outside = (other.path() / "b.xml").string();
  const auto result = correct(
      {edit(2, 3, "==", inside), edit(2, 3, "==", outside)},
      [&](const auto&) { return std::vector{edit(2, 3, "==", outside)}; },
      folder.path());
  ASSERT_EQ(result.texts.size(), 1u);
  ASSERT_TRUE(write_texts(result.texts));
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
