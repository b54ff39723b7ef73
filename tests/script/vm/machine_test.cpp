#include <gtest/gtest.h>

#include "script/vm/machine.hpp"
#include "tests/script/recording_host.hpp"

namespace parlour::script {

namespace {

// Loop registers: left, current, step, from, variable; bounds go in at 1 to 3.
std::vector<std::string> counted(Value from, Value step, Value to) {
  Machine machine(std::make_shared<const Program>());
  Box loop[5];
  loop[1] = Box::number(from.number_or(0));
  loop[2] = Box::number(step.number_or(0));
  loop[3] = Box::number(to.number_or(0));
  if (from.if_integer() && step.if_integer())
    for (int i = 1; i < 4; ++i)
      loop[i] = Box::small(static_cast<std::int64_t>(loop[i].as_number()));
  bool enters = false;
  EXPECT_TRUE(machine.for_prepare(loop, enters));
  std::vector<std::string> values;
  while (enters) {
    print(values.emplace_back(), loop[4], 100);
    enters = loop[0].as_small() > 0;
    EXPECT_TRUE(!enters || machine.for_next(loop));
  }
  return values;
}

TEST(Machine, CountsAForLoopBeforehand) {
  EXPECT_EQ(counted(1, 2, 6), (std::vector<std::string>{"1", "3", "5"}));
  EXPECT_EQ(counted(3, -1, 2), (std::vector<std::string>{"3", "2"}));
  EXPECT_TRUE(counted(1, 0, 1).empty());
  EXPECT_EQ(counted(0, 0.1, 0.3).size(), 4u);
}

TEST(Machine, AnIdleOneHoldsNothing) {
  Machine machine(std::make_shared<const Program>());
  EXPECT_EQ(machine.heap().used(), 0u);
}

} // namespace

} // namespace parlour::script
