// Checks the scripts below mistakes/, which have the mistakes of beginners: all
// findings must be those of x.txt beside x.xml, word by word. To write the
// expectations again after a change (and then to read each of them):
//
//   PARLOUR_WRITE_MISTAKES=1 test_script --gtest_filter='*Newcomers*'
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "script/lint/lint.hpp"
#include "script/source/excerpt.hpp"
#include "tests/script/snippets.hpp"
#include "tests/support/paths.hpp"

namespace parlour::script {

namespace {

namespace fs = std::filesystem;

const std::string folder = test::source_path("tests/script/mistakes");

std::vector<fs::path> mistakes() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const auto& path = entry.path();
    const auto settings = path.parent_path() / "settings.xml";
    if (path.extension() == ".xml" &&
        (path == settings || !fs::exists(settings)))
      files.push_back(path);
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

// What `parlour check` prints; a settings.xml stands for its application.
std::string said_of(const fs::path& file) {
  auto compiled =
      file.filename() == "settings.xml"
          ? compile_application(file.parent_path(), test::platform())
          : compile_file(file, test::platform());
  lint::lint(compiled, {});
  std::string said;
  for (auto finding : compiled.findings.all()) {
    const SourceText source(text_of(finding.place.file));
    finding.place.file = fs::path(finding.place.file).filename().string();
    said += to_string(finding) + '\n' + excerpt(source, finding);
  }
  return said;
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
  auto name = info.param.lexically_relative(folder).string();
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

} // namespace

class NewcomersMistakes : public testing::TestWithParam<fs::path> {};

TEST_P(NewcomersMistakes, are_told_so_that_a_newcomer_is_helped) {
  auto expected = GetParam();
  expected.replace_extension(".txt");
  const auto said = said_of(GetParam());
  EXPECT_NE(said, "");
  if (std::getenv("PARLOUR_WRITE_MISTAKES")) {
    std::ofstream(expected, std::ios::binary) << said;
    GTEST_SKIP() << "written";
  }
  EXPECT_EQ(said, text_of(expected));
}

INSTANTIATE_TEST_SUITE_P(All, NewcomersMistakes, testing::ValuesIn(mistakes()),
                         name_of);

} // namespace parlour::script
