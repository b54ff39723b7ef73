#include <gmock/gmock.h>

#include "adapters/http/policy/exchange.hpp"

namespace parlour::adapters::http {
namespace {

using std::chrono::seconds;
using testing::HasSubstr;

class ExchangeTest : public testing::Test {
protected:
  // The pause before the next try; -1: it is done.
  Milliseconds::rep next(const HttpAnswer& answer) {
    auto step = exchange.after(answer, now, 1);
    if (const auto* again = std::get_if<Exchange::Again>(&step))
      return again->pause.count();
    outcome = std::get<Exchange::Done>(step).outcome;
    return -1;
  }

  const Exchange::Moment now{seconds(1000)};
  Exchange exchange{
      HttpRequest{Method::get, "http://a/x"}, {{}, 3}, now + seconds(8)};
  TryOutcome outcome;
};

TEST_F(ExchangeTest, EndsWithAnAnswer) {
  EXPECT_EQ(next({404, "none"}), -1);
  EXPECT_EQ(outcome->body, "none");
}

TEST_F(ExchangeTest, TriesAgainAndThenGivesUp) {
  EXPECT_EQ(next({500}), 200);
  EXPECT_EQ(next({503}), 400);
  EXPECT_EQ(next({503}), -1);
  EXPECT_EQ(outcome->status, 503);
}

TEST_F(ExchangeTest, FollowsRedirectsAtOnce) {
  EXPECT_EQ(next({302, "", {}, "http://a/y"}), 0);
  EXPECT_EQ(exchange.request().address, "http://a/y");
  EXPECT_EQ(next({200, "there"}), -1);
  EXPECT_EQ(outcome->body, "there");
}

TEST_F(ExchangeTest, RunsInNoCircle) {
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(next({302, "", {}, "http://a/x"}), 0);
  EXPECT_EQ(next({302, "", {}, "http://a/x"}), -1);
  EXPECT_THAT(outcome.error().reason, HasSubstr("more than 3 times"));
}

TEST_F(ExchangeTest, RedirectsAndErrorsByTurnsEnd) {
  int steps = 0;
  while (next({steps % 2 ? 503 : 302, "", {}, "http://a/x"}) >= 0)
    ASSERT_LT(++steps, 10);
  EXPECT_GE(steps, 4);
}

TEST_F(ExchangeTest, DoesNotFollowEverywhere) {
  EXPECT_EQ(next({302, "", {}, "https://a/x"}), -1);
  EXPECT_THAT(outcome.error().reason, HasSubstr("from http to https"));
}

TEST_F(ExchangeTest, HasATimeThatIsLeft) {
  EXPECT_EQ(exchange.remaining(now), seconds(8));
  EXPECT_EQ(exchange.remaining(now + seconds(9)), seconds(0));
}

} // namespace
} // namespace parlour::adapters::http
