#include <gtest/gtest.h>

#include "adapters/http/policy/retry_policy.hpp"

namespace parlour::adapters::http {
namespace {

using Kind = HttpFailure::Kind;

constexpr Milliseconds long_time{60'000};
const HttpRequest get;
const HttpRequest post{Method::post, "http://a/", {}, {}, false};

TryOutcome answered(int status) {
  return HttpAnswer{status};
}

TryOutcome failed(Kind kind, bool was_sent) {
  return tl::make_unexpected(HttpFailure{kind, "failed", was_sent});
}

std::optional<Milliseconds> pause(const HttpRequest& request,
                                  const TryOutcome& outcome,
                                  unsigned tries = 1) {
  return pause_before_retry({}, request, outcome, tries, long_time, 1);
}

TEST(RetryPolicy, TriesAgainWhatMayBecomeBetter) {
  for (const auto status : {429, 500, 502, 503, 504})
    EXPECT_TRUE(pause(get, answered(status))) << status;
  for (const auto status : {200, 204, 301, 400, 401, 404, 409, 501})
    EXPECT_FALSE(pause(get, answered(status))) << status;
  for (const auto kind :
       {Kind::unreachable, Kind::late, Kind::broken_off, Kind::not_http})
    EXPECT_TRUE(pause(get, failed(kind, true)));
  for (const auto kind : {Kind::insecure, Kind::too_large, Kind::refused})
    EXPECT_FALSE(pause(get, failed(kind, true)));
}

// An SMS must not be sent twice.
TEST(RetryPolicy, RepeatsNothingThatMayHaveBeenDone) {
  EXPECT_FALSE(pause(post, answered(503)));
  EXPECT_FALSE(pause(post, failed(Kind::broken_off, true)));
  EXPECT_FALSE(pause(post, failed(Kind::late, true)));
  EXPECT_TRUE(pause(post, failed(Kind::unreachable, false)));
}

TEST(RetryPolicy, ThePausesGrow) {
  EXPECT_EQ(pause(get, answered(500), 1), Milliseconds(200));
  EXPECT_EQ(pause(get, answered(500), 2), Milliseconds(400));
  EXPECT_FALSE(pause(get, answered(500), 3));
  const RetryTerms many{100, Milliseconds(200), Milliseconds(5'000)};
  EXPECT_EQ(pause_before_retry(many, get, answered(500), 90, long_time, 1),
            Milliseconds(5'000));
}

TEST(RetryPolicy, ThePausesOfManyDiffer) {
  EXPECT_EQ(pause_before_retry({}, get, answered(500), 1, long_time, 0),
            Milliseconds(100));
  EXPECT_EQ(pause_before_retry({}, get, answered(500), 1, long_time, 0.5),
            Milliseconds(150));
}

TEST(RetryPolicy, ObeysTheServiceWithinTheTimeThatIsLeft) {
  const TryOutcome outcome = HttpAnswer{503, "", Milliseconds(2'000)};
  EXPECT_EQ(pause(get, outcome), Milliseconds(2'000));
  EXPECT_FALSE(pause_before_retry({}, get, outcome, 1, Milliseconds(2'000), 1));
  EXPECT_FALSE(
      pause_before_retry({}, get, answered(500), 1, Milliseconds(150), 1));
}

} // namespace
} // namespace parlour::adapters::http
