#include <string>

#include <gtest/gtest.h>

#include "script/source/text_positions.hpp"

namespace parlour::script {

TEST(TextPositions, count_columns_in_code_points) {
  const std::string text = "aé日x\nb";
  TextPositions positions(text, 3);
  EXPECT_EQ(positions.at(0), (Position{3, 1, 1}));
  EXPECT_EQ(positions.at(text.find('x')), (Position{3, 1, 4}));
  EXPECT_EQ(positions.at(text.find('b')), (Position{3, 2, 1}));
  EXPECT_EQ(positions.at(1000), (Position{3, 2, 2}));
}

TEST(TextPositions, know_all_ends_of_lines) {
  TextPositions positions("a\r\nb\rc\nd", 0);
  EXPECT_EQ(positions.at(3), (Position{0, 2, 1}));
  EXPECT_EQ(positions.at(5), (Position{0, 3, 1}));
  EXPECT_EQ(positions.at(7), (Position{0, 4, 1}));
}

TEST(TextPositions, find_the_offset_of_a_place) {
  const std::string text = "aé日x\nb";
  TextPositions positions(text, 0);
  for (std::size_t offset : {0u, 1u, 3u, 6u, 7u, 8u, 9u}) {
    const auto place = positions.at(offset);
    EXPECT_EQ(positions.offset_of(place.line, place.column), offset);
  }
  EXPECT_EQ(positions.offset_of(7, 1), text.size());
  EXPECT_EQ(positions.offset_of(0, 0), text.size());
}

TEST(TextPositions, know_long_lines) {
  std::string text;
  for (int i = 0; i < 3000; ++i)
    text += i % 3 == 0 ? "日" : "x";
  text = "é\n" + text + "\n" + text;
  TextPositions positions(text, 0);
  std::uint32_t line = 1, column = 1;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if ((static_cast<unsigned char>(text[at]) & 0xc0) == 0x80)
      continue;
    ASSERT_EQ(positions.at(at), (Position{0, line, column}));
    ASSERT_EQ(positions.offset_of(line, column), at);
    const bool ends = text[at] == '\n';
    column = ends ? 1 : column + 1;
    line += ends ? 1 : 0;
  }
}

TEST(ControlCharacters, are_found_wherever_they_stand) {
  std::string text = "a\tb\r\nc é 日本, and then some more of it\n";
  EXPECT_FALSE(find_control_character(text));
  for (std::size_t at = 0; at < text.size(); ++at)
    for (const char control : {'\0', '\x01', '\x0b', '\x1f'}) {
      auto with = text;
      with[at] = control;
      EXPECT_EQ(find_control_character(with), at);
    }
}

} // namespace parlour::script
