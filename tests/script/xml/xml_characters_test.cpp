#include <gtest/gtest.h>

#include "script/xml/xml_characters.hpp"

namespace parlour::script {

TEST(XmlCharacters, are_those_of_xml) {
  for (const std::uint32_t code : {0x9u, 0xau, 0xdu, 0x20u, 0x7fu, 0xd7ffu,
                                   0xe000u, 0xfffdu, 0x10000u, 0x10ffffu})
    EXPECT_TRUE(is_xml_character(code)) << code;
  for (const std::uint32_t code :
       {0x0u, 0x8u, 0xbu, 0x1fu, 0xd800u, 0xdfffu, 0xfffeu, 0xffffu, 0x110000u})
    EXPECT_FALSE(is_xml_character(code)) << code;
}

TEST(XmlCharacters, make_names) {
  EXPECT_EQ(xml_name_length("a-b.1 c"), 5u);
  EXPECT_EQ(xml_name_length("名前="), 6u);
  EXPECT_EQ(xml_name_length("_:x"), 3u);
  EXPECT_EQ(xml_name_length("a×b"), 1u);
  for (const auto* none : {"", "1a", "-a", ".a", "·a", "×", " a"})
    EXPECT_EQ(xml_name_length(none), 0u) << none;
}

} // namespace parlour::script
