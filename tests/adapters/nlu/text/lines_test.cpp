#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/nlu/text/lines.hpp"

namespace parlour::adapters::nlu {
namespace {

TEST(Lines, AreReadWithoutComments) {
  EXPECT_THAT(lines_of("# a list\none two\n\n  three # four\r\n#\nfive"),
              testing::ElementsAre("one two", "three", "five"));
  EXPECT_THAT(lines_of(""), testing::IsEmpty());
}

} // namespace
} // namespace parlour::adapters::nlu
