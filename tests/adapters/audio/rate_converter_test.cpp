#include <gtest/gtest.h>

#include "adapters/audio/rate_converter.hpp"

namespace parlour::adapters {
namespace {

TEST(RateConverterTest, RefusesWhatTheLibraryCannot) {
  const auto refused = RateConverter::create(4'000, 4'000 * 257, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::settings);
  EXPECT_NE(refused.error().message.find("the rate 4000 cannot be changed"),
            std::string::npos);
}

TEST(RateConverterTest, HoldsLittleBack) {
  auto converter = RateConverter::create(48'000, 16'000, 1);
  ASSERT_TRUE(converter);
  std::vector<float> out;
  converter->process(std::vector<float>(4'800), out);
  EXPECT_GT(out.size(), 1'600U - 100U);
  converter->finish(out);
  EXPECT_NEAR(static_cast<double>(out.size()), 1'600, 1);
}

TEST(RateConverterTest, NothingGivesNothing) {
  auto converter = RateConverter::create(8'000, 16'000, 2);
  ASSERT_TRUE(converter);
  std::vector<float> out;
  converter->process({}, out);
  converter->finish(out);
  EXPECT_TRUE(out.empty());
}

} // namespace
} // namespace parlour::adapters
