#include "script/dialogue/context/ending.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

TEST(Ending, GoesFromStageToStage) {
  Ending ending;
  EXPECT_FALSE(ending.is_wished());
  ending.wish();
  EXPECT_TRUE(ending.is_wished());
  EXPECT_FALSE(ending.has_begun());
  EXPECT_TRUE(ending.begin());
  EXPECT_TRUE(ending.has_begun());
  EXPECT_TRUE(ending.tell());
  EXPECT_FALSE(ending.is_over());
  ending.finish();
  EXPECT_TRUE(ending.is_over());
}

TEST(Ending, BeginsWithoutAWishWhereTheUserIsGone) {
  Ending ending;
  EXPECT_TRUE(ending.begin());
  EXPECT_TRUE(ending.is_wished());
}

TEST(Ending, FinishesWhereNotAllCouldBeTold) {
  Ending ending;
  ending.begin();
  ending.finish();
  EXPECT_TRUE(ending.is_over());
  EXPECT_FALSE(ending.tell());
}

TEST(Ending, EachStageComesOnce) {
  Ending ending;
  ending.begin();
  ending.tell();
  EXPECT_FALSE(ending.begin());
  EXPECT_FALSE(ending.tell());
  ending.finish();
  EXPECT_FALSE(ending.begin());
}

TEST(Ending, NeverGoesBack) {
  Ending ending;
  ending.begin();
  ending.wish(); // by a script of an Exit
  EXPECT_TRUE(ending.has_begun());
  ending.finish();
  ending.wish();
  EXPECT_TRUE(ending.is_over());
}

TEST(Ending, ComesBackAtItsStage) {
  Ending ending;
  ending.begin();
  ending.tell();
  auto again = round_trip(ending);
  EXPECT_TRUE(again.has_begun());
  EXPECT_FALSE(again.tell());
}

} // namespace
} // namespace parlour::dialogue
