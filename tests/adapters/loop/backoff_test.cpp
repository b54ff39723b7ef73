#include <gtest/gtest.h>

#include "adapters/loop/backoff.hpp"

namespace parlour::adapters {
namespace {

TEST(Backoff, PausesTwiceAsLongUpToABound) {
  Backoff backoff(Milliseconds(200), Milliseconds(1'000));
  for (const auto pause : {200, 400, 800, 1'000, 1'000})
    EXPECT_EQ(backoff.after_failure(), Milliseconds(pause));
  backoff.reset();
  for (const auto pause : {200, 400})
    EXPECT_EQ(backoff.after_failure(), Milliseconds(pause));
}

} // namespace
} // namespace parlour::adapters
