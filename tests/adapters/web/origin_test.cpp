#include <gtest/gtest.h>

#include "adapters/web/origin.hpp"

namespace parlour::adapters::web {
namespace {

TEST(Origin, OfThisMachineMayConnect) {
  for (const auto* origin : {"http://localhost", "http://localhost:8080",
                             "https://127.0.0.1:1", "http://[::1]:80"})
    EXPECT_TRUE(is_allowed_origin(origin, {})) << origin;
}

TEST(Origin, OfElsewhereMayNotUnlessItIsNamed) {
  for (const auto* origin :
       {"https://example.com", "null", "", "localhost", "http://localhost.evil",
        "http://evil/localhost", "http://[::1", "https://kiosk.example:8080"})
    EXPECT_FALSE(is_allowed_origin(origin, {"https://kiosk.example"}))
        << origin;
  EXPECT_TRUE(
      is_allowed_origin("https://kiosk.example", {"https://kiosk.example"}));
}

} // namespace
} // namespace parlour::adapters::web
