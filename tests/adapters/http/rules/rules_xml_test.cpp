#include <gmock/gmock.h>
#include <pugixml.hpp>

#include "adapters/http/rules/rules_xml.hpp"

namespace parlour::adapters::http {
namespace {

using testing::ElementsAre;

TEST(RulesXml, CollectsMistakesInTheOrderOfTheirLines) {
  const std::string text = "<a>\n<b x='1'/>\n<c/></a>";
  const std::string file = "a.xml";
  pugi::xml_document document;
  document.load_buffer(text.data(), text.size());
  const auto root = document.document_element();
  RulesXml xml(text, file);
  xml.unknown(root.child("c"), "<b>");
  EXPECT_FALSE(xml.check_attributes(root.child("b"), {"name"}, {"value"}));
  EXPECT_TRUE(xml.check_attributes(root.child("b"), {"x"}));
  EXPECT_TRUE(xml.has_errors());
  std::vector<std::string> texts;
  for (const auto& error : xml.take_errors())
    texts.push_back(to_string(error));
  EXPECT_THAT(
      texts,
      ElementsAre("a.xml:2: <b> has no attribute 'x'; there are name, value",
                  "a.xml:2: <b> needs the attribute 'name'",
                  "a.xml:3: <c> is not known in <a>; there are <b>"));
  EXPECT_FALSE(xml.has_errors());
}

TEST(RulesXml, TextHasNoBlanksAroundAndNoComments) {
  pugi::xml_document document;
  document.load_string("<a>\n x <!-- no --><![CDATA[<y> ]]>\n</a>");
  EXPECT_EQ(text_of(document.document_element()), "x <y>");
}

} // namespace
} // namespace parlour::adapters::http
