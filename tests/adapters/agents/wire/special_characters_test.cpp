#include <string>

#include <gtest/gtest.h>

#include "adapters/agents/wire/special_characters.hpp"

namespace parlour::adapters::agents {
namespace {

// Long fields are looked at in blocks.
TEST(SpecialCharacters, AreFoundAnywhere) {
  for (const char special : {',', '"', '\n', '\r', '\\'})
    for (std::size_t size = 1; size < 70; ++size)
      for (std::size_t at = 0; at < size; ++at) {
        std::string field(size, 'x');
        field[at] = special;
        ASSERT_TRUE(has_special(field)) << size << ' ' << at;
      }
}

TEST(SpecialCharacters, AreFew) {
  std::string all;
  for (int c = 0; c < 256; ++c)
    if (std::string_view(",\"\n\r\\").find(static_cast<char>(c)) ==
        std::string_view::npos)
      all += static_cast<char>(c);
  EXPECT_FALSE(has_special(all));
  EXPECT_FALSE(has_special(""));
  for (const char c : all)
    EXPECT_FALSE(has_special({&c, 1}));
}

} // namespace
} // namespace parlour::adapters::agents
