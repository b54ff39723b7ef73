#include "actors/routing/reply_registry.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(ReplyRegistry, GiveAnAnswerToItsQueryOnce) {
  Bench bench;
  ReplyRegistry registry;
  auto first = bench.query_probe();
  auto second = bench.query_probe();
  const auto one = registry.add(first);
  const auto two = registry.add(second);
  EXPECT_NE(one, two);
  EXPECT_EQ(registry.take(two), second);
  EXPECT_EQ(registry.take(one), first);
  EXPECT_FALSE(registry.take(one));
}

TEST(ReplyRegistry, GiveAllAnswersToWhoWantsAllUntilItForgets) {
  Bench bench;
  ReplyRegistry registry;
  auto query = bench.query_probe();
  const auto correlation = registry.add(query, ReplyRegistry::Wants::all);
  EXPECT_EQ(registry.take(correlation), query);
  EXPECT_EQ(registry.take(correlation), query);
  registry.forget(correlation);
  EXPECT_FALSE(registry.take(correlation));
}

TEST(ReplyRegistry, KeepAwayFromTheNumbersOfSessions) {
  ReplyRegistry registry;
  EXPECT_GT(registry.add({}), Correlation{1} << 63);
  EXPECT_FALSE(registry.take(1));
}

} // namespace
} // namespace parlour::actors
