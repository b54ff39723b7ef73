#include <gmock/gmock.h>

#include "script/schema/ways.hpp"

namespace parlour::script {

using testing::ElementsAre;

namespace {

// "name! step" and, behind a minus, what is left out.
std::vector<std::string> ways(const char* element, const char* within) {
  std::vector<std::string> all;
  for (const auto& way : ways_of(*find_rule(element, {within}))) {
    std::string text;
    for (const auto& attribute : way.attributes)
      text += (text.empty() ? "" : " ") + attribute.rule.name +
              (attribute.required ? "!" : "");
    for (const auto& child : way.without)
      text += " -" + child;
    all.push_back(std::move(text));
  }
  return all;
}

} // namespace

TEST(Ways, is_one_where_nothing_excludes_anything) {
  EXPECT_THAT(ways("timer", "statements"),
              ElementsAre("name! after! repeat keeps-open ends-with"));
}

TEST(Ways, are_the_forms) {
  EXPECT_THAT(ways("for", "statements"),
              ElementsAre("name! from! to! step", "each! in! index"));
  EXPECT_THAT(ways("object", "statements"),
              ElementsAre("name! class!", "name! class! size!"));
}

TEST(Ways, leave_out_what_an_attribute_stands_for) {
  EXPECT_THAT(ways("value", "values"), ElementsAre("", "expr! -text"));
  EXPECT_THAT(ways("fire", "statements"),
              ElementsAre("param! -param", "event!", "param! event! -param"));
}

TEST(Ways, choose_by_words) {
  const auto all = ways_of(*find_rule("cardinality", {"slot"}));
  EXPECT_THAT(all.front().attributes.front().rule.words, ElementsAre("set"));
}

} // namespace parlour::script
