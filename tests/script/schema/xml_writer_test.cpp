#include <gtest/gtest.h>

#include "script/schema/xml_writer.hpp"

namespace parlour::script {

TEST(XmlWriter, indents_and_escapes) {
  XmlWriter xml;
  xml.element("a", {{"x", "1<\"&"}}, [&] {
    xml.empty("b");
    xml.text("c", "<d>");
  });
  EXPECT_EQ(xml.take(), "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                        "<a x=\"1&lt;&quot;&amp;\">\n  <b/>\n"
                        "  <c>&lt;d></c>\n</a>\n");
}

} // namespace parlour::script
