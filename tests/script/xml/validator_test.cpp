#include <gmock/gmock.h>

#include "script/xml/validator.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

std::vector<std::string> judge(Element& root) {
  Findings findings;
  findings.add_file("a.xml");
  validate(root, {"dialogue", "settings"}, findings);
  return test::lines_of(findings);
}

std::vector<std::string> judge(const std::string& text) {
  auto root = test::tree_of(text);
  return judge(root);
}

} // namespace

struct Told {
  const char* text; // inside of <dialogue>, from column 11 on
  const char* finding;
};

class Mistakes : public testing::TestWithParam<Told> {};

TEST_P(Mistakes, are_told_exactly) {
  const auto lines =
      judge(std::string("<dialogue>") + GetParam().text + "</dialogue>");
  EXPECT_THAT(lines, ElementsAre(std::string("a.xml:1:") + GetParam().finding));
}

INSTANTIATE_TEST_SUITE_P(
    elements, Mistakes,
    testing::Values(
        Told{"<hander name='h'/>", "11: error: unknown element <hander> in "
                                   "<dialogue>, did you mean 'handler'?"},
        Told{"<xyzzy/>",
             "11: error: unknown element <xyzzy> in <dialogue>; expected "
             "include, var, const, functions, function, handler, routes, "
             "state, topic, facts, grammar, pronounce, phrases or "
             "repair"},
        Told{"<slot name='s'/>", "11: error: <slot> may not stand in "
                                 "<dialogue>; it belongs in <topic>"},
        Told{"<post module='A' command='b'/>",
             "11: error: <post> may not stand in <dialogue>; it is a "
             "statement: put it into a <function>, a state's <Entrance>, an "
             "event or the like"},
        Told{"<filled/>", "11: error: <filled> may not stand in <dialogue>; it "
                          "belongs in <slot> or <topic>"},
        Told{"<state name='s'><Enter/></state>",
             "27: error: unknown element <Enter> in <state>; here it is "
             "called <Entrance>"},
        Told{"<state name='s'><Before/></state>",
             "27: error: unknown element <Before> in <state>; expected "
             "functions, messages, Entrance, Exit, Online or Offline"},
        Told{"<include href='x'><a/></include>",
             "29: error: unknown element <a> in <include>; it holds no "
             "elements"},
        Told{"hello <var name='x'/>",
             "11: error: text 'hello' may not stand in "
             "<dialogue>; expected elements only"},
        Told{"<function name='f'><reload/></function>",
             "30: error: <reload> is not available yet"},
        Told{"<function name='f'><reload sessions='keep'><x/></reload>"
             "</function>",
             "30: error: <reload> is not available yet"}));

INSTANTIATE_TEST_SUITE_P(
    attributes, Mistakes,
    testing::Values(
        Told{"<state/>",
             "11: error: <state> needs the attribute 'name': its name"},
        Told{"<var nmae='x' name='y'/>",
             "16: error: <var> has no attribute 'nmae', did you mean 'name'?"},
        Told{"<var name='x' colour='red'/>",
             "25: error: <var> has no attribute 'colour'; it has name, expr or "
             "private"},
        Told{"<var name='2x'/>",
             "22: error: name=\"2x\" of <var>: expected a name: a letter or _, "
             "then letters, digits or _"},
        Told{"<var name=''/>",
             "22: error: name=\"\" of <var>: expected a name: a letter or _, "
             "then letters, digits or _"},
        Told{"<var name='x' private='yes'/>",
             "34: error: private=\"yes\" of <var>: expected true or false"},
        Told{"<topic name='t' kind='tsak'/>",
             "33: error: kind=\"tsak\" of <topic>: expected task or enquiry, "
             "did you mean 'task'?"},
        Told{"<topic name='t'><slot name='s' type='functional'/></topic>",
             "48: error: type=\"functional\" of <slot>: expected Functional or "
             "Informational, did you mean 'Functional'?"},
        Told{
            "<topic name='t'><slot name='s'><noinput count='two'/></slot>"
            "</topic>",
            "58: error: count=\"two\" of <noinput>: expected a whole number, 0 "
            "or more"},
        Told{"<function name='f'><wait for='2 days'/></function>",
             "41: error: for=\"2 days\" of <wait>: expected a duration such as "
             "200ms, 1.5s or 2m"},
        Told{"<function name='f'><post command='c'/></function>",
             "30: error: <post> needs the attribute 'module': a role or a "
             "component"},
        Told{"<function name='f'><if><break/></if></function>",
             "30: error: <if> needs the attribute 'cond': the condition"},
        Told{"<include/>",
             "11: error: <include> needs the attribute 'href': a file of the "
             "application, or parlour:name"}));

INSTANTIATE_TEST_SUITE_P(
    forms, Mistakes,
    testing::Values(
        Told{"<function name='f'><for name='i' in='[1]'/></function>",
             "44: error: <for> has both 'name' and 'in'; write either name, "
             "from, to, step, or each, in, index"},
        Told{"<function name='f'><object name='a' class='array'/>"
             "</function>",
             "30: error: <object> needs the attribute 'size': elements of an "
             "array"},
        Told{"<function name='f'><fire/></function>",
             "30: error: <fire> needs the attribute 'param' or 'event'"},
        Told{"<topic name='t'><slot name='s'><cardinality type='number' "
             "from='1'/></slot></topic>",
             "69: error: <cardinality type=\"number\"> has no 'from'; that "
             "belongs to type=\"range\""}));

TEST(Validator,
     accepts_the_paper_s_spellings_and_either_case_of_first_letters) {
  EXPECT_THAT(judge("<Dialogue><State name='s'><entrance><Print param='x'/>"
                    "</entrance><messages/></State></Dialogue>"),
              IsEmpty());
  EXPECT_THAT(judge("<settings><plugins><plugin>A</plugin></plugins>"
                    "</settings>"),
              IsEmpty());
}

TEST(Validator, leaves_the_levels_of_sources_and_events_free) {
  EXPECT_THAT(judge("<dialogue><handler name='h'><messages><component>"
                    "<Foo><Bar><print param='x'/></Bar></Foo>"
                    "<on source='*' event='a-b'><consume/></on>"
                    "</component></messages></handler></dialogue>"),
              IsEmpty());
  EXPECT_THAT(judge("<dialogue><handler name='h'><messages><component>"
                    "<Foo x='1'><Bar><prnt param='a'/></Bar></Foo>"
                    "</component></messages></handler></dialogue>"),
              ElementsAre("a.xml:1:55: error: <Foo> has no attribute 'x'",
                          "a.xml:1:66: error: unknown element <prnt> in <Bar>, "
                          "did you mean 'print'?"));
}

TEST(Validator, tells_all_at_once) {
  EXPECT_EQ(judge("<dialogue>a<b/><var/><state nam='x'/></dialogue>").size(),
            4u);
}

TEST(Validator, wants_the_right_root) {
  EXPECT_THAT(judge("<html/>"),
              ElementsAre("a.xml:1:1: error: the root element is <html>; "
                          "expected <dialogue> or <settings>"));
}

TEST(Validator, mends_the_tree_for_those_who_come_after) {
  auto root =
      test::tree_of("<dialogue><x/><function name='f'><if><break/></if><post/>"
                    "<reload/></function></dialogue>");
  EXPECT_EQ(judge(root).size(), 5u);
  ASSERT_EQ(root.children.size(), 1u);
  const auto& body = root.children[0].children;
  ASSERT_EQ(body.size(), 1u);
  EXPECT_EQ(body[0].value("cond"), "unknown");
  EXPECT_TRUE(body[0].child("break"));
}

} // namespace parlour::script
