#include <gtest/gtest.h>

#include "actors/routing/round_limit.hpp"

namespace parlour::actors {
namespace {

using Verdict = RoundLimit::Verdict;

Message message(std::uint32_t rounds, SessionId session = "s",
                Timestamp time = 5'000) {
  Message made;
  made.rounds = rounds;
  made.session = std::move(session);
  made.time = time;
  return made;
}

TEST(RoundLimit, LetsWhatIsNearPass) {
  RoundLimit limit;
  for (std::uint32_t i = 0; i < 3 * RoundLimit::each_second; ++i)
    ASSERT_EQ(limit.judge(message(RoundLimit::honest_rounds)), Verdict::passes);
}

TEST(RoundLimit, EndsWhatIsFarAndMuch) {
  RoundLimit limit;
  for (std::uint32_t i = 0; i < RoundLimit::each_second; ++i)
    ASSERT_EQ(limit.judge(message(100)), Verdict::passes);
  EXPECT_EQ(limit.judge(message(100)), Verdict::first_too_many);
  EXPECT_EQ(limit.judge(message(100)), Verdict::too_many);
  EXPECT_EQ(limit.judge(message(100, "another")), Verdict::passes);
  EXPECT_EQ(limit.judge(message(100, "s", 6'000)), Verdict::passes);
}

} // namespace
} // namespace parlour::actors
