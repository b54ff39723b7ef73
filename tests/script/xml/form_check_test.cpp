#include <gmock/gmock.h>

#include "script/xml/form_check.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

using testing::ElementsAre;
using testing::IsEmpty;

namespace {

class FormCheck : public testing::Test {
protected:
  // The attributes that are left.
  std::vector<std::string> left(const std::string& text) {
    findings = {};
    findings.add_file("a.xml");
    auto root = test::tree_of(text);
    well = check_forms(root, rule_of(root), findings);
    std::vector<std::string> names;
    for (const auto& attribute : root.attributes)
      names.push_back(attribute.name);
    return names;
  }
  static std::vector<std::string> missing(const std::string& text) {
    const auto root = test::tree_of(text);
    std::vector<std::string> names;
    for (const auto* attribute : missing_of_form(root, rule_of(root)))
      names.push_back(attribute->name);
    return names;
  }
  std::vector<std::string> said() const {
    return test::lines_of(findings);
  }
  bool well = false;

private:
  static const ElementRule& rule_of(const Element& root) {
    return *find_rule(root.name, {"statements", "routes", "slot", "values"});
  }
  Findings findings;
};

} // namespace

TEST_F(FormCheck, lets_pass_what_goes_together) {
  for (const auto* text :
       {"<for name='i' from='1' to='2'/>", "<for each='x' in='l' index='i'/>",
        "<fire event='e' param='x'/>", "<cancel/>", "<ask/>",
        "<cardinality type='range' to='3'/>", "<cardinality type='date'/>",
        "<filter source='a' command='b' to='c' drop='false'/>",
        "<post module='a' command='b'><param/></post>"}) {
    left(text);
    EXPECT_TRUE(well) << text;
    EXPECT_THAT(missing(text), IsEmpty()) << text;
  }
}

TEST_F(FormCheck, tells_of_the_first_that_excludes_another) {
  EXPECT_THAT(left("<for each='x' in='l' from='1' to='2'/>"),
              ElementsAre("each", "in"));
  EXPECT_FALSE(well);
  EXPECT_THAT(said(), ElementsAre("a.xml:1:22: error: <for> has both 'each' "
                                  "and 'from'; write either name, from, to, "
                                  "step, or each, in, index"));
  left("<filter source='a' command='b' drop='true' to='c'/>");
  EXPECT_THAT(said(), ElementsAre("a.xml:1:44: error: <filter> has both "
                                  "drop=\"true\" and 'to'; write either to, "
                                  "as, param, or drop"));
}

TEST_F(FormCheck, tells_where_an_attribute_belongs) {
  EXPECT_THAT(left("<cardinality from='1' type='set'/>"), ElementsAre("type"));
  EXPECT_THAT(said(),
              ElementsAre("a.xml:1:14: error: <cardinality type=\"set\"> has "
                          "no 'from'; that belongs to type=\"range\""));
}

TEST_F(FormCheck, tells_of_what_is_said_twice) {
  EXPECT_THAT(left("<post module='a' command='b' param='c'><param/></post>"),
              ElementsAre("module", "command"));
  EXPECT_THAT(said(),
              ElementsAre("a.xml:1:30: error: <post> has both 'param' and "
                          "<param> inside of it; leave one out"));
  left("<value expr='1'> a </value>");
  EXPECT_THAT(said(), ElementsAre("a.xml:1:8: error: <value> has both 'expr' "
                                  "and a text inside of it; leave one out"));
  left("<value expr='1'> </value>");
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(FormCheck, knows_what_is_missing) {
  EXPECT_THAT(missing("<for name='i' to='2'/>"), ElementsAre("from"));
  EXPECT_THAT(missing("<for/>"), ElementsAre("name", "each"));
  EXPECT_THAT(missing("<cardinality type='range'/>"),
              ElementsAre("from", "to"));
  EXPECT_THAT(missing("<filter source='a' command='b' drop='false'/>"),
              ElementsAre("to", "drop"));
  EXPECT_THAT(missing("<object class='array' name='a'/>"), ElementsAre("size"));
}

} // namespace parlour::script
