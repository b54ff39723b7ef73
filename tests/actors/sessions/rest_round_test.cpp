#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/sessions/rest_round.hpp"

namespace parlour::actors {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::map<SessionId, int> sessions(std::size_t count) {
  std::map<SessionId, int> made;
  for (std::size_t number = 0; number < count; ++number)
    made[std::to_string(10'000 + number)] = 0;
  return made;
}

TEST(RestRound, TellsAllTwiceInTheTime) {
  RestRound round;
  EXPECT_EQ(round.until_next(10s), 5s);
  EXPECT_THAT(round.next(sessions(2), 10s), ElementsAre("10000", "10001"));
  EXPECT_EQ(round.until_next(10s), 5s);
  EXPECT_THAT(round.next(sessions(2), 10s), ElementsAre("10000", "10001"));
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
