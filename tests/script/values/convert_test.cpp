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

TEST(Convert, SharesTextsThatAreConstants) {
  ConstantPool constants;
  const auto written = constants.string("written");
  Heap heap(nullptr, 1 << 20);
  const Value value(Map{{"written", Value(List{"written", "computed"})}});
  const auto box = to_box(heap, value, constants);
  EXPECT_EQ(to_value(box), value);
  const auto& entry = box.map()->entries.front();
  EXPECT_TRUE(entry.key.same_bits(written));
  EXPECT_TRUE(entry.value.list()->elements[0].same_bits(written));
  EXPECT_FALSE(entry.value.list()->elements[1].string()->interned);
}

// As many as make an index, and fewer.
TEST(Convert, FindsWhatIsInAMap) {
  Heap heap(nullptr, 1 << 20);
  for (const int size : {0, 8, 9, 100}) {
    Map map;
    for (int i = 0; i < size; ++i)
      map.set("key " + std::to_string(i), i);
    const auto box = to_box(heap, map);
    for (int i = 0; i < size; ++i) {
      const auto* found = box.map()->find("key " + std::to_string(i));
      ASSERT_TRUE(found);
      EXPECT_EQ(found->as_small(), i);
    }
    EXPECT_FALSE(box.map()->find("key"));
    box.map()->set(make_string(heap, "key"), Box::boolean(true));
    EXPECT_TRUE(box.map()->find("key"));
  }
}

TEST(Convert, StopsWhereACopyWouldBeFarLargerThanTheStructure) {
  Heap heap(nullptr, 1 << 20);
  auto box = make_list(heap);
  for (int i = 0; i < 60; ++i) {
    auto twice = make_list(heap);
    twice.list()->elements.assign(2, box);
    box = std::move(twice);
  }
  WalkBudget budget(1000 * WalkBudget::bytes_per_value);
  to_value(box, budget);
  EXPECT_TRUE(budget.exhausted());
}

TEST(Convert, WeighsAsMuchAsACopyWouldTake) {
  Heap heap(nullptr, 1 << 20);
  auto box = make_list(heap);
  for (int i = 0; i < 4; ++i) {
    auto twice = make_list(heap);
    twice.list()->elements.assign(2, box);
    box = twice;
  }
  // 31 lists.
  WalkBudget measured(32 * WalkBudget::bytes_per_value);
  WalkBudget copied = measured;
  measure(box, measured);
  to_value(box, copied);
  EXPECT_EQ(measured.left(), WalkBudget::bytes_per_value);
  EXPECT_EQ(copied.left(), measured.left());
  WalkBudget little(30 * WalkBudget::bytes_per_value);
  measure(box, little);
  EXPECT_TRUE(little.exhausted());
}

TEST(Convert, CountsTextsByTheirBytesAndKeysToo) {
  Heap heap(nullptr, 1 << 20);
  auto map = make_map(heap);
  map.map()->set(make_string(heap, "key"), make_string(heap, "text"));
  WalkBudget measured(100);
  WalkBudget copied = measured;
  measure(map, measured);
  to_value(map, copied);
  EXPECT_EQ(measured.left(), 100 - 2 * WalkBudget::bytes_per_value - 7);
  EXPECT_EQ(copied.left(), measured.left());
}

} // namespace

} // namespace parlour::script
