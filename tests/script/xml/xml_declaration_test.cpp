#include <gtest/gtest.h>

#include "script/xml/xml_declaration.hpp"

namespace parlour::script {

TEST(XmlDeclaration, is_known_however_it_is_spelt) {
  EXPECT_TRUE(is_xml_declaration("<?xml version='1.0'?>"));
  EXPECT_TRUE(is_xml_declaration("<?XML?>"));
  EXPECT_FALSE(is_xml_declaration("<?xml-model x?>"));
  EXPECT_FALSE(is_xml_declaration("<?xml"));
  EXPECT_FALSE(is_xml_declaration("<xml/>"));
}

TEST(XmlDeclaration, says_version_encoding_and_standalone) {
  EXPECT_FALSE(declaration_fault("<?xml version='1.0'?><a/>", 0));
  const auto fault = declaration_fault("<?xml version='1.0' encoding='?>", 0);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->offset, 0u);
}

} // namespace parlour::script
