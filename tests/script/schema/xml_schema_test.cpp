#include <gmock/gmock.h>

#include "script/schema/xml_schema.hpp"

namespace parlour::script {

using testing::HasSubstr;

TEST(XmlSchema, says_what_things_are_for) {
  const auto schema = xml_schema();
  EXPECT_THAT(schema, HasSubstr("<xs:element name=\"dialogue\""));
  EXPECT_THAT(schema, HasSubstr("<xs:element name=\"RecognitionResult\""));
  EXPECT_THAT(schema, HasSubstr("<xs:documentation>say it</xs:documentation>"));
  EXPECT_THAT(schema, HasSubstr("<xs:enumeration value=\"Functional\"/>"));
}

} // namespace parlour::script
