#include <gtest/gtest.h>

#include "script/program/jump_table.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

TEST(JumpTable, FindsTheArmOfAString) {
  ConstantPool pool;
  JumpTable table;
  for (std::uint32_t i = 0; i < 100; ++i)
    table.add(pool.string("arm " + std::to_string(i)), i);
  table.otherwise(777);
  Heap heap(nullptr, 1 << 20);
  for (std::uint32_t i = 0; i < 100; ++i)
    EXPECT_EQ(*table.find(make_string(heap, "arm " + std::to_string(i))), i);
  EXPECT_EQ(*table.find(make_string(heap, "leg")), 777u);
}

TEST(JumpTable, FindsTheArmOfAnInteger) {
  JumpTable table;
  for (std::uint32_t i = 0; i < 20; ++i)
    table.add(Box::small(i * 1000 - 5000), i);
  table.otherwise(777);
  EXPECT_EQ(*table.find(Box::small(3000)), 8u);
  EXPECT_EQ(*table.find(Box::small(3001)), 777u);
}

TEST(JumpTable, TheFirstOfEqualConstantsCounts) {
  JumpTable table;
  table.add(Box::small(1), 10);
  table.add(Box::small(1), 20);
  EXPECT_EQ(*table.find(Box::small(1)), 10u);
}

TEST(JumpTable, HasOneType) {
  ConstantPool pool;
  JumpTable table;
  EXPECT_TRUE(JumpTable::may_hold(Box::small(1)));
  EXPECT_FALSE(JumpTable::may_hold(Box::number(1.5)));
  EXPECT_FALSE(JumpTable::may_hold(Box()));
  table.add(pool.string("5"), 1);
  EXPECT_EQ(table.find(Box::small(5)), nullptr); // '5' == 5
}

} // namespace

} // namespace parlour::script
