#include <gmock/gmock.h>

#include "runtime/base/limited_log.hpp"

namespace parlour {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(LimitedLog, HasALineNowAndThen) {
  LimitedLog<std::string> log(Milliseconds(10'000));
  LimitedLog<std::string>::Moment now{};
  EXPECT_EQ(log.note("state", "first", now), "first");
  EXPECT_EQ(log.note("state", "second", now), std::nullopt);
  EXPECT_EQ(log.note("size", "other", now), "other");
  now += Milliseconds(9'999);
  EXPECT_EQ(log.note("state", "third", now), std::nullopt);
  now += Milliseconds(1);
  EXPECT_EQ(log.note("state", "fourth", now), "fourth (and 2 more)");
  EXPECT_EQ(log.count("state"), 4U);
  EXPECT_EQ(log.count("size"), 1U);
  EXPECT_EQ(log.count("number"), 0U);
  EXPECT_THAT(log.counts(), ElementsAre(Pair("size", 1U), Pair("state", 4U)));
}

} // namespace
} // namespace parlour
