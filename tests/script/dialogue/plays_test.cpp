// Runs the plays below plays/: scripts with a conversation in their comments
// (play.hpp).
#include <algorithm>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "tests/script/dialogue/play.hpp"
#include "tests/support/paths.hpp"

namespace parlour::dialogue {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> plays() {
  std::vector<fs::path> files;
  for (const auto& entry :
       fs::directory_iterator(test::source_path("tests/script/dialogue/plays")))
    if (entry.path().extension() == ".xml")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

class LanguagePlay : public testing::TestWithParam<fs::path> {};

TEST_P(LanguagePlay, GoesAsItsMarginSays) {
  expect_as_in_play(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Language, LanguagePlay, testing::ValuesIn(plays()),
                         [](const auto& play) {
                           return play.param.stem().string();
                         });

} // namespace
} // namespace parlour::dialogue
