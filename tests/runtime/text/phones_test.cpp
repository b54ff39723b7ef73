#include <gmock/gmock.h>

#include "runtime/text/phones.hpp"

namespace parlour {
namespace {

using testing::HasSubstr;

TEST(Phones, are_told_from_other_texts) {
  EXPECT_TRUE(is_phone("HH"));
  EXPECT_FALSE(is_phone("hh"));
  EXPECT_FALSE(is_phone("AH0"));
  EXPECT_FALSE(is_phone(""));
}

TEST(Phones, that_are_none_are_named) {
  EXPECT_FALSE(mistake_in_phones("HH OW"));
  EXPECT_FALSE(mistake_in_phones("  HH   OW "));
  EXPECT_THAT(mistake_in_phones("HH OQ").value(),
              HasSubstr("there is no phone 'OQ'; the phones are AA AE"));
  EXPECT_THAT(mistake_in_phones("hh ow").value(),
              HasSubstr("'hh'; did you mean 'HH'?"));
  EXPECT_THAT(mistake_in_phones("HH OW1").value(),
              HasSubstr("'OW1'; did you mean 'OW'?"));
  EXPECT_THAT(mistake_in_phones(" ").value(), HasSubstr("no phones are given"));
}

TEST(Phones, have_one_blank_between_them) {
  EXPECT_EQ(tidy_phones("  HH \n OW "), "HH OW");
}

} // namespace
} // namespace parlour
