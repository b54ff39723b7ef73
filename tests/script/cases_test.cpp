// Language cases: small scripts with the expectation in the margin (margin.hpp)
// below cases/, a folder for each section of the language.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/script/margin.hpp"

namespace parlour::script {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> cases() {
  std::vector<fs::path> files;
  const fs::path root = PARLOUR_SOURCE_DIR "/tests/script/cases";
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.path().extension() == ".xml")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string name_of_case(const testing::TestParamInfo<fs::path>& info) {
  auto name = info.param.parent_path().filename().string() + "_" +
              info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(),
      [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

class LanguageCase : public testing::TestWithParam<fs::path> {};

TEST_P(LanguageCase, DoesWhatItsMarginSays) {
  test::expect_as_in_margin(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Language, LanguageCase, testing::ValuesIn(cases()),
                         name_of_case);

} // namespace

} // namespace parlour::script
