#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/sessions/rest_round.hpp"

namespace parlour::actors {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pointee;
using testing::SizeIs;

// By their ids, which are not in a row.
std::map<caf::actor_id, int> sessions(std::size_t count) {
  std::map<caf::actor_id, int> made;
  for (std::size_t number = 1; number <= count; ++number)
    made[number * 7] = static_cast<int>(number);
  return made;
}

TEST(RestRound, TellsAllTwiceInTheTime) {
  RestRound round;
  const auto all = sessions(2);
  EXPECT_EQ(round.until_next(10s), 5s);
  EXPECT_THAT(round.next(all, 10s), ElementsAre(Pointee(1), Pointee(2)));
  EXPECT_EQ(round.until_next(10s), 5s);
  EXPECT_THAT(round.next(all, 10s), ElementsAre(Pointee(1), Pointee(2)));
}

TEST(RestRound, TellsSomeAtATime) {
  RestRound round;
  const auto all = sessions(RestRound::at_once + 2);
  EXPECT_THAT(round.next(all, 10s), SizeIs(RestRound::at_once));
  EXPECT_EQ(round.until_next(10s), RestRound::between);
  EXPECT_THAT(round.next(all, 10s), SizeIs(2));
  EXPECT_EQ(round.until_next(10s), 5s);
}

TEST(RestRound, GoesOnWhereSessionsHaveEnded) {
  RestRound round;
  round.next(sessions(RestRound::at_once + 2), 10s);
  EXPECT_THAT(round.next(sessions(0), 10s), IsEmpty());
  EXPECT_EQ(round.until_next(10s), 5s);
}

TEST(RestRound, TellsNobodyWhereNobodyRests) {
  RestRound round;
  EXPECT_EQ(round.until_next(0s), RestRound::look_again);
  EXPECT_THAT(round.next(sessions(2), 0s), IsEmpty());
  EXPECT_EQ(round.until_next(10s), 5s);
  EXPECT_THAT(round.next(sessions(2), 10s), SizeIs(2));
}

} // namespace
} // namespace parlour::actors
