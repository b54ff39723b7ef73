#include <gmock/gmock.h>

#include "script/xml/content_check.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

class ContentCheck : public testing::Test {
protected:
  // The children that are left, each with its own in brackets.
  std::string left(const std::string& text) {
    findings = {};
    findings.add_file("a.xml");
    auto root = test::tree_of(text);
    const auto& rule = *find_rule(root.name, {"statements", "script"});
    gather_parts(root, rule, findings);
    check_children(root, rule, findings);
    return shown(root);
  }
  std::vector<std::string> said() const {
    return test::lines_of(findings);
  }

private:
  static std::string shown(const Element& element) {
    std::string text;
    for (const auto& child : element.children)
      text += (text.empty() ? "" : " ") + child.name +
              (child.children.empty() ? "" : "(" + shown(child) + ")");
    return text;
  }

  Findings findings;
};

} // namespace

TEST_F(ContentCheck, gives_an_empty_part_what_stands_behind_it) {
  EXPECT_EQ(left("<if><pop/><elseif/><log/><print/><else/><end/></if>"),
            "pop elseif(log print) else(end)");
  EXPECT_EQ(left("<if><pop/><else/></if>"), "pop else");
  EXPECT_EQ(left("<if><Else/><end/></if>"), "Else(end)");
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(ContentCheck, leaves_parts_that_hold_their_own) {
  EXPECT_EQ(left("<if><pop/><elseif/><else><end/></else></if>"),
            "pop elseif else(end)");
  EXPECT_EQ(left("<if><pop/><elseif><log/></elseif><else/></if>"),
            "pop elseif(log) else");
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(ContentCheck, tells_of_two_ways_in_one) {
  left("<if><pop/><elseif/><log/><else><end/></else></if>");
  EXPECT_THAT(said(),
              ElementsAre("a.xml:1:26: error: <else> holds its statements, "
                          "and <elseif/> stands in front of them; write one "
                          "<if> in one of both ways"));
}

TEST_F(ContentCheck, tells_of_what_stands_behind_a_part_once) {
  EXPECT_EQ(left("<if><pop/><else><end/></else><log/><print/></if>"),
            "pop else(end)");
  EXPECT_THAT(said(), ElementsAre("a.xml:1:30: error: <log> stands behind "
                                  "<else>; put it in front of that, or into "
                                  "it"));
}

TEST_F(ContentCheck, keeps_the_order_of_what_comes_last) {
  EXPECT_EQ(left("<if><else><end/></else><elseif><pop/></elseif></if>"),
            "else(end)");
  EXPECT_THAT(said(), ElementsAre("a.xml:1:24: error: <elseif> stands behind "
                                  "<else>; put it in front of that"));
  EXPECT_EQ(left("<try><catch/><log/></try>"), "catch");
  EXPECT_THAT(said(), ElementsAre("a.xml:1:14: error: <log> stands behind "
                                  "<catch>; put it in front of that, or into "
                                  "it"));
}

TEST_F(ContentCheck, counts_what_may_be_there_once) {
  EXPECT_EQ(left("<switch><default/><case/><case/><Default/></switch>"),
            "default case case");
  EXPECT_THAT(said(), ElementsAre("a.xml:1:33: error: a second <Default> in "
                                  "<switch>, after the one in line 1; put both "
                                  "into one, or take one out"));
}

} // namespace parlour::script
