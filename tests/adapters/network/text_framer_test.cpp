#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/network/text_framer.hpp"

namespace parlour::adapters {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(TextFramer, GivesLines) {
  TextFramer framer(true);
  EXPECT_THAT(framer.take("one\ntw"), ElementsAre("one"));
  EXPECT_THAT(framer.take("o\r\n\nthree"), ElementsAre("two", ""));
  EXPECT_THAT(framer.take(""), IsEmpty());
  EXPECT_EQ(framer.rest(), "three");
  EXPECT_EQ(framer.rest(), "");
}

TEST(TextFramer, GivesWhatCame) {
  TextFramer framer(false);
  EXPECT_THAT(framer.take("one\ntw"), ElementsAre("one\ntw"));
  EXPECT_THAT(framer.take("o"), ElementsAre("o"));
  EXPECT_EQ(framer.rest(), "");
}

TEST(TextFramer, CutsNoCharacter) {
  TextFramer framer(false);
  EXPECT_THAT(framer.take("a\xe2"), ElementsAre("a"));
  EXPECT_THAT(framer.take("\x82"), IsEmpty());
  EXPECT_THAT(framer.take("\xac"), ElementsAre("\u20ac"));
  EXPECT_THAT(framer.take("\xf0\x9f\x98"), IsEmpty());
  EXPECT_THAT(framer.take("\x80!"), ElementsAre("\U0001F600!"));
}

TEST(TextFramer, RepairsWhatIsNotUtf8) {
  TextFramer framer(true);
  EXPECT_THAT(framer.take("caf\xe9\n"), ElementsAre("caf\ufffd"));
  TextFramer rest(false);
  EXPECT_THAT(rest.take("\xc3"), IsEmpty());
  EXPECT_EQ(rest.rest(), "\ufffd");
  EXPECT_THAT(TextFramer(false).take("\x80\x80\x80\x80").size(), 1u);
}

TEST(TextFramer, ALongLineComesInPieces) {
  TextFramer framer(true);
  const std::string half(TextFramer::longest_text / 2, 'x');
  EXPECT_THAT(framer.take(half), IsEmpty());
  EXPECT_THAT(framer.take(half), IsEmpty());
  EXPECT_THAT(framer.take("yz"), ElementsAre(half + half + "yz"));
  EXPECT_THAT(framer.take("end\n"), ElementsAre("end"));
}

} // namespace
} // namespace parlour::adapters
