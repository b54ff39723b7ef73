#include <gtest/gtest.h>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {
namespace {

TEST(Measure, the_median_is_the_middle_one) {
  EXPECT_EQ(median({9, 1, 5}), 5);
  EXPECT_EQ(median({4}), 4);
  EXPECT_EQ(median({}), 0);
}

TEST(Measure, cpu_time_does_not_go_back) {
  const auto before = cpu_nanoseconds();
  EXPECT_GE(cpu_nanoseconds(), before);
}

TEST(Measure, memory_given_out_is_counted) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer's memory is not malloc's";
#endif
  const auto before = bytes_in_use();
  const std::string text(100'000, 'x');
  EXPECT_GE(bytes_in_use(), before + text.size());
}

} // namespace
} // namespace parlour::tools
