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
  WalkBudget budget(1000);
  EXPECT_FALSE(append(outer, inner, budget));
  EXPECT_EQ(budget.price(), 0u); // nobody else has it: nothing to search
  EXPECT_EQ(append(inner, outer, budget)->kind, ErrorKind::range);
  EXPECT_GT(budget.price(), 0u);
  EXPECT_TRUE(inner.list()->elements.empty());
}

TEST(Operations, WhatCannotBeSearchedForARingIsRefused) {
  Heap heap(nullptr, 1 << 20);
  auto list = make_list(heap);
  const Box other = list;
  const auto large = make_list(heap);
  large.list()->elements.resize(1000);
  WalkBudget budget(1000);
  EXPECT_EQ(append(list, large, budget)->kind, ErrorKind::limit);
  EXPECT_TRUE(list.list()->elements.empty());
}

// What is printed to be a key is not cut: it would be another's key.
TEST(Operations, WhatIsTooLongToBeAKeyIsRefused) {
  Heap heap(nullptr, 64 << 20);
  auto list = make_list(heap);
  list.list()->elements.push_back(
      make_string(heap, std::string((1 << 20) - 10, 'a')));
  const auto map = make_map(heap);
  const auto text = make_string(heap, "a");
  WalkBudget budget(1 << 30);
  Box found;
  bool is_there = true;
  EXPECT_FALSE(set_index(heap, map, list, Box::small(1), budget));
  EXPECT_FALSE(get_index(heap, map, list, found));
  EXPECT_EQ(found.as_small(), 1);
  EXPECT_FALSE(is_in(list, map, is_there, budget));
  EXPECT_TRUE(is_there);
  list.list()->elements.push_back(make_string(heap, "twenty letters or so"));
  EXPECT_TRUE(key_text(heap, list).is_missing());
  EXPECT_EQ(set_index(heap, map, list, Box::small(2), budget)->kind,
            ErrorKind::limit);
  EXPECT_EQ(set_index(heap, Box(), list, Box::small(2), budget)->kind,
            ErrorKind::limit);
  EXPECT_EQ(get_index(heap, map, list, found)->kind, ErrorKind::limit);
  EXPECT_EQ(is_in(list, map, is_there, budget)->kind, ErrorKind::limit);
  EXPECT_EQ(is_in(list, text, is_there, budget)->kind, ErrorKind::limit);
  EXPECT_EQ(map.map()->entries.size(), 1u);
}

// Two lists of one long text each, a thousand times: not a thousand bytes.
TEST(Operations, ComparingAndOrderingTakeTheBytesThatTheyRead) {
  Heap heap(nullptr, 1 << 20);
  const std::string text(1000, '7');
  auto left = make_list(heap);
  auto right = make_list(heap);
  left.list()->elements.assign(1000, make_string(heap, text));
  right.list()->elements.assign(1000, make_string(heap, text));
  WalkBudget budget(2'000'000);
  EXPECT_TRUE(equal(left, right, budget));
  EXPECT_EQ(budget.left(), 2'000'000u - 8u - 1000u * 1008u);
  WalkBudget small(10'000);
  EXPECT_FALSE(equal(left, right, small));
  EXPECT_TRUE(small.exhausted());
  WalkBudget digits(999);
  Order found = Order::none;
  EXPECT_FALSE(order(make_string(heap, text), Box::small(1), found, digits));
  EXPECT_TRUE(digits.exhausted());
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
