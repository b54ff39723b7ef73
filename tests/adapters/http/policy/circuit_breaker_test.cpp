#include <gmock/gmock.h>

#include "adapters/http/policy/circuit_breaker.hpp"

namespace parlour::adapters::http {
namespace {

using State = CircuitBreaker::State;
using std::chrono::seconds;
using testing::HasSubstr;

class CircuitBreakerTest : public testing::Test {
protected:
  void fail(unsigned times = 1) {
    for (unsigned i = 0; i < times; ++i)
      breaker.failed(breaker.admit(now).value(), now, "answered 503");
  }

  CircuitBreaker breaker{{3, seconds(30)}};
  CircuitBreaker::Moment now{seconds(1000)};
};

TEST_F(CircuitBreakerTest, LetsAllPassWhileTheServiceWorks) {
  for (int i = 0; i < 100; ++i)
    breaker.succeeded(breaker.admit(now).value());
  EXPECT_EQ(breaker.state(now), State::closed);
}

TEST_F(CircuitBreakerTest, OpensAfterFailuresInARow) {
  fail(2);
  breaker.succeeded(*breaker.admit(now)); // the row is interrupted
  fail(2);
  EXPECT_EQ(breaker.state(now), State::closed);
  fail();
  EXPECT_EQ(breaker.state(now), State::open);
  EXPECT_FALSE(breaker.admit(now));
  EXPECT_FALSE(breaker.admit(now + seconds(29)));
}

TEST_F(CircuitBreakerTest, SaysForHowLong) {
  fail(3);
  EXPECT_EQ(breaker.refusal(now + seconds(4)),
            "has failed 3 times in a row (it answered 503), so it is not "
            "asked for 26 s more");
}

TEST_F(CircuitBreakerTest, LetsOneTryAfterThePause) {
  fail(3);
  now += seconds(30);
  EXPECT_EQ(breaker.state(now), State::half_open);
  const auto trial = breaker.admit(now);
  ASSERT_TRUE(trial);
  EXPECT_TRUE(trial->is_trial);
  EXPECT_FALSE(breaker.admit(now));
  EXPECT_THAT(breaker.refusal(now), HasSubstr("tried with one request first"));
  breaker.succeeded(*trial);
  EXPECT_EQ(breaker.state(now), State::closed);
  EXPECT_TRUE(breaker.admit(now));
}

TEST_F(CircuitBreakerTest, OpensAgainIfTheTrialFails) {
  fail(3);
  now += seconds(30);
  fail();
  EXPECT_EQ(breaker.state(now), State::open);
  EXPECT_FALSE(breaker.admit(now + seconds(29)));
  EXPECT_TRUE(breaker.admit(now + seconds(30)));
}

TEST_F(CircuitBreakerTest, ATrialThatIsWithdrawnLeavesRoomForAnother) {
  fail(3);
  now += seconds(30);
  breaker.withdrawn(*breaker.admit(now));
  EXPECT_TRUE(breaker.admit(now));
}

// They say nothing about how the service is now.
TEST_F(CircuitBreakerTest, LateOutcomesFromBeforeChangeNothing) {
  const auto early = breaker.admit(now).value();
  fail(3);
  breaker.succeeded(early);
  EXPECT_EQ(breaker.state(now), State::open);
  breaker.failed(early, now + seconds(20), "answered 500");
  EXPECT_EQ(breaker.state(now + seconds(30)), State::half_open);
}

TEST_F(CircuitBreakerTest, NeverOpensIfToldSo) {
  breaker = CircuitBreaker({0, seconds(30)});
  fail(1000);
  EXPECT_EQ(breaker.state(now), State::closed);
}

} // namespace
} // namespace parlour::adapters::http
