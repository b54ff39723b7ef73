#include "actors/routing/query_claims.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

TEST(QueryClaims, GiveAnAnswerToItsQueryOnce) {
  Bench bench;
  QueryClaims claims;
  auto first = bench.query_probe();
  auto second = bench.query_probe();
  const auto one = claims.claim(first);
  const auto two = claims.claim(second);
  EXPECT_NE(one, two);
  EXPECT_EQ(claims.take(two), second);
  EXPECT_EQ(claims.take(one), first);
  EXPECT_FALSE(claims.take(one));
}

TEST(QueryClaims, GiveAllAnswersToWhoWantsAllUntilItForgets) {
  Bench bench;
  QueryClaims claims;
  auto query = bench.query_probe();
  const auto claim = claims.claim(query, QueryClaims::Wants::all);
  EXPECT_EQ(claims.take(claim), query);
  EXPECT_EQ(claims.take(claim), query);
  claims.forget(claim);
  EXPECT_FALSE(claims.take(claim));
}

TEST(QueryClaims, KeepAwayFromTheNumbersOfSessions) {
  QueryClaims claims;
  EXPECT_GT(claims.claim({}), Correlation{1} << 63);
  EXPECT_FALSE(claims.take(1));
}

} // namespace
} // namespace parlour::actors
