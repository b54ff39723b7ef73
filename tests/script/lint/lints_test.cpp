#include <fstream>
#include <iterator>
#include <set>

#include <gtest/gtest.h>

#include "script/lint/lints.hpp"
#include "tests/support/paths.hpp"

namespace parlour::script::lint {

TEST(Lints, have_names_and_sentences_of_their_own) {
  std::set<std::string> names, sentences;
  for (const auto& one : lints()) {
    EXPECT_TRUE(is_lint(one.name));
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_TRUE(sentences.insert(one.sentence).second) << one.sentence;
  }
  EXPECT_FALSE(is_lint("no-such-lint"));
}

// The page of the documentation has the table's words.
TEST(Lints, are_documented) {
  std::ifstream file(test::source_path("docs/check.md"));
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  std::size_t at = 0;
  for (const auto& one : lints()) {
    at = page.find("| `" + one.name + "` | " + one.sentence + " |\n", at);
    ASSERT_NE(at, std::string::npos) << one.name;
  }
}

} // namespace parlour::script::lint
