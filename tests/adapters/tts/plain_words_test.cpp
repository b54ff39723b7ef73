#include <gtest/gtest.h>

#include "adapters/tts/plain_words.hpp"

namespace parlour::adapters::tts {
namespace {

TEST(PlainWords, have_ascii_alone) {
  EXPECT_EQ(in_plain_letters("10:30am,"), "10:30am,");
  EXPECT_EQ(in_plain_letters("Café"), "Cafe");
  EXPECT_EQ(in_plain_letters("“Zoë’s”"), "\"Zoe's\"");
  EXPECT_EQ(in_plain_letters("Москва"), "Moskva");
  EXPECT_EQ(in_plain_letters("\xf0\x9f\x99\x82"), "");
}

} // namespace
} // namespace parlour::adapters::tts
