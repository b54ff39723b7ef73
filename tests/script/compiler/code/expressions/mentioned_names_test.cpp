#include <gtest/gtest.h>

#include "script/compiler/code/expressions/mentioned_names.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

using Names = std::set<std::string, std::less<>>;

Names mentioned(const std::string& statements) {
  return mentioned_names(test::tree_of("<t>" + statements + "</t>"));
}

TEST(MentionedNames, AreThoseOfExpressionsAndOfTextsWithBraces) {
  EXPECT_EQ(mentioned(R"x(<set name="total.sum" expr="a + f(b.c[d])"/>)x"),
            (Names{"total", "a", "b", "d"}));
  EXPECT_EQ(
      mentioned(R"x(<speak param="Hello {name}, {{no}} {'it is ' + day}"/>)x"),
      (Names{"name", "day"}));
  EXPECT_EQ(mentioned(R"x(<querydb param="select a from t where b = {c}"
                           args="d, e" return="rows"/>)x"),
            (Names{"c", "d", "e", "rows"}));
  EXPECT_EQ(mentioned(R"x(<if cond="x gt 1"><if cond="y"/></if>)x"),
            (Names{"x", "y"}));
}

TEST(MentionedNames, ArePartsOfNoOtherWord) {
  EXPECT_EQ(mentioned(R"x(<speak param="It counts: counter"/>)x"), Names{});
  EXPECT_EQ(mentioned(R"x(<print param="{'count'}"/>)x"), Names{});
  EXPECT_EQ(mentioned(R"x(<print param="{counter}"/>)x"), Names{"counter"});
  EXPECT_EQ(mentioned(R"x(<var name="m" expr="{count: 1}"/>)x"), Names{"m"});
}

} // namespace

} // namespace parlour::script
