#include <gmock/gmock.h>

#include "script/schema/relax_ng.hpp"
#include "script/xml/xml_mistakes.hpp"

namespace parlour::script {

using testing::HasSubstr;

// That it accepts and refuses what it should,
// tests/tools/parlour/cli/scripts/schema_test.py shows.
TEST(RelaxNg, is_well_formed_and_says_what_things_are_for) {
  const auto schema = relax_ng_schema();
  EXPECT_TRUE(find_xml_mistakes(schema).empty());
  EXPECT_THAT(schema, HasSubstr("<name>speak</name>"));
  EXPECT_THAT(schema, HasSubstr("<name>Speak</name>"));
  EXPECT_THAT(schema, HasSubstr("<a:documentation>say it</a:documentation>"));
  EXPECT_THAT(schema, HasSubstr("<value type=\"string\">Functional</value>"));
}

} // namespace parlour::script
