#include <gtest/gtest.h>

#include "runtime/text/words.hpp"

namespace parlour {

using Words = std::vector<std::string>;

TEST(Words, StandBetweenBlanks) {
  EXPECT_EQ(split_words("a bc  d"), (Words{"a", "bc", "d"}));
  EXPECT_EQ(split_words(" \n\ta\r\n"), Words{"a"});
  EXPECT_EQ(split_words(" \t"), Words{});
  EXPECT_EQ(split_words(""), Words{});
}

} // namespace parlour
