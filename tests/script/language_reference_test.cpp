// Every example of script/LANGUAGE.md does what its comments say. An example
// without <dialogue> is the children of it; one without a declaration is the
// body of `main`.
#include <algorithm>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/script/margin.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::script {

namespace {

struct Example {
  std::string rule; // "2.3"
  std::string text;
};

void PrintTo(const Example& example, std::ostream* stream) {
  *stream << example.rule;
}

// "**2.3**" at the beginning of a line.
std::string rule_of(const std::string& line) {
  if (!line.starts_with("**"))
    return {};
  return line.substr(2, line.find("**", 2) - 2);
}

struct Reference {
  std::vector<std::string> rules;
  std::vector<Example> examples;
};

Reference read_reference() {
  Reference reference;
  std::ifstream file(test::source_path("script/LANGUAGE.md"));
  std::string line;
  bool inside = false;
  while (std::getline(file, line)) {
    if (inside && line == "```")
      inside = false;
    else if (inside)
      reference.examples.back().text += line + '\n';
    else if (auto rule = rule_of(line); !rule.empty())
      reference.rules.push_back(rule);
    else if (line == "```xml" && !reference.rules.empty()) {
      reference.examples.push_back({reference.rules.back(), ""});
      inside = true;
    }
  }
  return reference;
}

bool declares(const std::string& text) {
  for (auto name : {"<function ", "<handler ", "<state ", "<topic ", "<routes>",
                    "<facts", "<phrases>"})
    if (text.find(name) != std::string::npos)
      return true;
  return false;
}

// Line numbers stay as they are.
std::string whole(const std::string& text) {
  if (text.find("<dialogue>") != std::string::npos)
    return text;
  if (declares(text))
    return "<dialogue>" + text + "</dialogue>";
  return "<dialogue><function name=\"main\">" + text + "</function></dialogue>";
}

std::string name_of_example(const testing::TestParamInfo<Example>& info) {
  auto name = "Rule_" + info.param.rule + "_" + std::to_string(info.index);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

class LanguageReference : public testing::TestWithParam<Example> {};

TEST_P(LanguageReference, SaysWhatHappens) {
  test::TemporaryFolder folder;
  folder.write("example.xml", whole(GetParam().text));
  test::expect_as_in_margin(folder.path() / "example.xml");
  test::expect_as_in_margin(folder.path() / "example.xml",
                            test::run_with_restores); // rule 10.4
}

INSTANTIATE_TEST_SUITE_P(Script, LanguageReference,
                         testing::ValuesIn(read_reference().examples),
                         name_of_example);

TEST(LanguageReferenceText, EveryRuleHasAnExample) {
  const auto reference = read_reference();
  ASSERT_FALSE(reference.rules.empty());
  for (const auto& rule : reference.rules)
    EXPECT_TRUE(std::any_of(
        reference.examples.begin(), reference.examples.end(),
        [&](const Example& example) { return example.rule == rule; }))
        << rule;
}

TEST(LanguageReferenceText, RulesAreNumberedInOrder) {
  int section = 0;
  int number = 0;
  for (const auto& rule : read_reference().rules) {
    const auto next =
        std::to_string(section) + "." + std::to_string(number + 1);
    const auto first = std::to_string(section + 1) + ".1";
    EXPECT_TRUE(rule == next || rule == first) << rule;
    number = rule == next ? number + 1 : 1;
    section += rule == next ? 0 : 1;
  }
}

} // namespace

} // namespace parlour::script
