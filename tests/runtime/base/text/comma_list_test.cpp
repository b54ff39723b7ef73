#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/text/comma_list.hpp"

namespace parlour {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(CommaListTest, HasItsParts) {
  EXPECT_THAT(split_at_commas("hey parlour, computer"),
              ElementsAre("hey parlour", "computer"));
  EXPECT_THAT(split_at_commas("one"), ElementsAre("one"));
}

TEST(CommaListTest, LeavesOutWhatIsEmpty) {
  EXPECT_THAT(split_at_commas(""), IsEmpty());
  EXPECT_THAT(split_at_commas(" , ,"), IsEmpty());
  EXPECT_THAT(split_at_commas(",a, ,\tb\n,"), ElementsAre("a", "b"));
}

} // namespace
} // namespace parlour
