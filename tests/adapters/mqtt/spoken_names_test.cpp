#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/mqtt/spoken_names.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SpokenNames, AreWords) {
  EXPECT_THAT(words_of("Living-Room_Lamp/2"),
              ElementsAre("living", "room", "lamp", "2"));
  EXPECT_THAT(words_of("KÜCHE, Straße"), ElementsAre("küche", "strasse"));
  EXPECT_THAT(words_of("客厅 灯"), ElementsAre("客厅", "灯"));
  EXPECT_THAT(words_of(""), IsEmpty());
  EXPECT_THAT(words_of("--- /"), IsEmpty());
}

TEST(SpokenNames, StandInARow) {
  const auto name = words_of("kitchen ceiling lamp");
  EXPECT_TRUE(contains(name, {"ceiling", "lamp"}));
  EXPECT_TRUE(contains(name, {"kitchen"}));
  EXPECT_FALSE(contains(name, {"kitchen", "lamp"}));
  EXPECT_FALSE(contains(name, {"kit"}));
  EXPECT_FALSE(contains(name, {}));
}

} // namespace
} // namespace parlour::adapters::mqtt
