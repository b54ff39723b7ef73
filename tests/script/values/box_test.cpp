// A debug build ends where a box is taken for what it is not.
#include <gtest/gtest.h>

#include "script/values/objects.hpp"

namespace parlour::script {
namespace {

#ifndef NDEBUG

TEST(BoxDeathTest, is_no_integer_where_it_is_something_else) {
  EXPECT_DEATH(Box::boolean(true).as_small(), "is_small");
  EXPECT_DEATH(Box().as_integer(), "is_integer");
  EXPECT_DEATH(Box::small(std::int64_t{1} << 50), "fits");
}

TEST(BoxDeathTest, is_no_number_where_it_is_an_integer) {
  EXPECT_DEATH(Box::small(1).as_number(), "is_number");
}

TEST(BoxDeathTest, points_to_nothing_where_it_is_a_number) {
  EXPECT_DEATH(Box::number(1).object(), "is_object");
  EXPECT_DEATH(Box::number(1).target(), "is_reference");
}

TEST(BoxDeathTest, is_no_list_where_it_is_a_map) {
  Heap heap(nullptr, 1000);
  const auto map = make_map(heap);
  EXPECT_NE(map.map(), nullptr);
  EXPECT_DEATH(map.list(), "is_list");
  EXPECT_DEATH(map.string(), "is_string");
  EXPECT_DEATH(map.error(), "error");
}

TEST(HeapDeathTest, gives_back_no_more_than_was_taken) {
  Heap heap(nullptr, 1000);
  heap.account(10);
  EXPECT_DEATH(heap.discount(11), "used_");
}

#endif

} // namespace
} // namespace parlour::script
