#include <gtest/gtest.h>

#include "script/values/convert.hpp"

namespace parlour::script {

namespace {

TEST(Convert, BringsEveryValueThereAndBack) {
  Heap heap(nullptr, 1 << 20);
  ResultSet rows;
  rows.columns = {"a"};
  rows.cells = {Value(1)};
  const Value value(List{Value(), Value(true), Value(INT64_MAX), Value(1.5),
                         Value("text"), Value(Map{{"k", Value(List{})}}),
                         Value(rows)});
  EXPECT_EQ(to_value(to_box(heap, value)), value);
}

TEST(Convert, StopsWhereACopyWouldBeFarLargerThanTheStructure) {
  Heap heap(nullptr, 1 << 20);
  auto box = make_list(heap);
  for (int i = 0; i < 60; ++i) {
    auto twice = make_list(heap);
    twice.list()->elements.assign(2, box);
    box = std::move(twice);
  }
  bool truncated = false;
  to_value(box, 1000, &truncated);
  EXPECT_TRUE(truncated);
}

TEST(Convert, WeighsAsMuchAsACopyWouldTake) {
  Heap heap(nullptr, 1 << 20);
  auto box = make_list(heap);
  for (int i = 0; i < 4; ++i) {
    auto twice = make_list(heap);
    twice.list()->elements.assign(2, box);
    box = twice;
  }
  std::size_t budget = 32; // 31 lists
  weigh(box, budget);
  EXPECT_EQ(budget, 1u);
  budget = 30;
  weigh(box, budget);
  EXPECT_EQ(budget, 0u);
  budget = 5;
  weigh(make_string(heap, std::string(3 * sizeof(Value), 'x')), budget);
  EXPECT_EQ(budget, 1u);
  weigh(make_string(heap, std::string(3 * sizeof(Value), 'x')), budget);
  EXPECT_EQ(budget, 0u);
}

} // namespace

} // namespace parlour::script
