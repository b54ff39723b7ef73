// The ranges are copied from the XML recommendation and tested one by one;
// names are short and most characters are in the first ranges.

#include "script/xml/xml_characters.hpp"

#include <algorithm>
#include <iterator>

namespace parlour::script {

namespace {

struct Range {
  std::uint32_t first;
  std::uint32_t last;
};

// The ranges of the productions Char, NameStartChar and NameChar.
constexpr Range characters[] = {{0x9, 0xa},
                                {0xd, 0xd},
                                {0x20, 0xd7ff},
                                {0xe000, 0xfffd},
                                {0x10000, 0x10ffff}};
constexpr Range name_starts[] = {
    {':', ':'},       {'A', 'Z'},       {'_', '_'},       {'a', 'z'},
    {0xc0, 0xd6},     {0xd8, 0xf6},     {0xf8, 0x2ff},    {0x370, 0x37d},
    {0x37f, 0x1fff},  {0x200c, 0x200d}, {0x2070, 0x218f}, {0x2c00, 0x2fef},
    {0x3001, 0xd7ff}, {0xf900, 0xfdcf}, {0xfdf0, 0xfffd}, {0x10000, 0xeffff}};
constexpr Range name_goes_on[] = {
    {'-', '.'}, {'0', '9'}, {0xb7, 0xb7}, {0x300, 0x36f}, {0x203f, 0x2040}};

template <std::size_t size>
bool is_in(const Range (&ranges)[size], std::uint32_t code) {
  return std::any_of(std::begin(ranges), std::end(ranges),
                     [code](const Range& range) {
                       return range.first <= code && code <= range.last;
                     });
}

struct Character {
  std::uint32_t code = 0;
  std::size_t length = 1;
};

// Decodes the first code point of valid UTF-8.
Character first_of(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80)
    return {lead, 1};
  const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  std::uint32_t code = lead & (0x7fu >> length);
  for (std::size_t i = 1; i < length && i < text.size(); ++i)
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3fu);
  return {code, std::min(length, text.size())};
}

} // namespace

bool is_xml_character(std::uint32_t code) {
  return is_in(characters, code);
}

std::size_t xml_name_length(std::string_view text) {
  std::size_t length = 0;
  while (length < text.size()) {
    const auto next = first_of(text.substr(length));
    if (!is_in(name_starts, next.code) &&
        (length == 0 || !is_in(name_goes_on, next.code)))
      break;
    length += next.length;
  }
  return length;
}

} // namespace parlour::script
