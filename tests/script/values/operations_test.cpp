#include <gtest/gtest.h>

#include "script/values/operations.hpp"

namespace parlour::script {

namespace {

TEST(Operations, IntegersAndNumbersCompareExactly) {
  const Numeric integer{true, 9007199254740993, 0};
  const Numeric number{false, 0, 9007199254740992.0};
  EXPECT_EQ(compare(integer, number), 1);
  EXPECT_EQ(compare(number, integer), -1);
  EXPECT_EQ(compare({false, 0, -0.5}, {true, 0, 0}), -1);
  EXPECT_EQ(compare({true, INT64_MAX, 0}, {false, 0, 9223372036854775808.0}),
            -1);
}

TEST(Operations, TheLeastIntegerHasNoOpposite) {
  Heap heap(nullptr, 1 << 20);
  Box result;
  const auto least = make_integer(heap, INT64_MIN);
  EXPECT_FALSE(
      arithmetic(heap, Arithmetic::divide, least, Box::small(-1), result));
  EXPECT_EQ(result.as_number(), 9223372036854775808.0);
  EXPECT_FALSE(
      arithmetic(heap, Arithmetic::modulo, least, Box::small(-1), result));
  EXPECT_EQ(result.as_small(), 0);
}

TEST(Operations, ARefusedRingLeavesTheListAsItWas) {
  Heap heap(nullptr, 1 << 20);
  auto outer = make_list(heap);
  auto inner = make_list(heap);
  std::size_t work = 0;
  EXPECT_FALSE(append(outer, inner, work));
  EXPECT_EQ(work, 0u); // nobody else has it: there is nothing to search
  EXPECT_TRUE(append(inner, outer, work));
  EXPECT_GT(work, 0u);
  EXPECT_TRUE(inner.list()->elements.empty());
}

TEST(Operations, find_text_takes_time_by_the_size_of_the_text) {
  EXPECT_EQ(find_text("hello", "l"), 2u);
  EXPECT_EQ(find_text("hello", "l", 3), 3u);
  EXPECT_EQ(find_text("hello", "", 5), 5u);
  EXPECT_EQ(find_text("hello", "", 6), std::string_view::npos);
  EXPECT_EQ(find_text("hello", "lx"), std::string_view::npos);
  // Hours, if each place were compared in full.
  const std::string text(8 << 20, 'a');
  EXPECT_EQ(find_text(text, std::string(4 << 20, 'a') + 'b'),
            std::string_view::npos);
}

// Four bytes that announce four each are as many code points as bytes; the
// last of them are behind the end.
TEST(Operations, a_text_that_is_no_utf8_is_not_read_behind_its_end) {
  Heap heap(nullptr, 1 << 20);
  const auto text = make_string(heap, "\xf0\xf0\xf0\xff\x80");
  ASSERT_EQ(text.string()->code_points, 4u);
  for (int i = -4; i < 4; ++i) {
    Box result;
    EXPECT_FALSE(get_index(heap, text, Box::small(i), result)) << i;
    EXPECT_TRUE(result.is_string());
  }
}

} // namespace

} // namespace parlour::script
