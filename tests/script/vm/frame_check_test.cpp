#include <gtest/gtest.h>

#include "script/program/instruction.hpp"
#include "script/values/objects.hpp"
#include "script/vm/frame_check.hpp"

namespace parlour::script {

namespace {

Instruction make(Operation operation, std::uint16_t a = 0, std::uint16_t b = 0,
                 std::uint8_t flag = 0) {
  return {static_cast<std::uint8_t>(operation), flag, a, b, 0};
}

TEST(FrameCheck, AnArgumentIsBoundUntilItsCall) {
  Code code;
  code.instructions = {make(Operation::bind_variable, 3),
                       make(Operation::move, 4, 5), // another argument
                       make(Operation::call, 3, 0, 2),
                       make(Operation::give_unknown)};
  EXPECT_FALSE(FrameCheck(code, 0).may_be_bound(3));
  EXPECT_TRUE(FrameCheck(code, 1).may_be_bound(3));
  EXPECT_TRUE(FrameCheck(code, 2).may_be_bound(3));
  EXPECT_FALSE(FrameCheck(code, 2).may_be_bound(4));
  EXPECT_FALSE(FrameCheck(code, 3).may_be_bound(3));
}

TEST(FrameCheck, ParametersMayAlwaysBeBound) {
  Code code;
  code.parameter_count = 1;
  code.instructions = {make(Operation::give_unknown)};
  EXPECT_TRUE(FrameCheck(code, 0).may_be_bound(0));
  EXPECT_FALSE(FrameCheck(code, 0).may_be_bound(1));
  EXPECT_FALSE(FrameCheck(code, 0).may_be_missing(0));
}

TEST(FrameCheck, AParameterIsMissingUntilItHasItsDefault) {
  Code code;
  code.parameter_count = 1;
  code.instructions = {make(Operation::jump_if_given, 0, 2),
                       make(Operation::move, 0, 1),
                       make(Operation::give_unknown)};
  EXPECT_TRUE(FrameCheck(code, 0).may_be_missing(0));
  EXPECT_TRUE(FrameCheck(code, 1).may_be_missing(0));
  EXPECT_FALSE(FrameCheck(code, 2).may_be_missing(0));
}

TEST(FrameCheck, AForCountsWithoutOverflow) {
  Code code;
  code.instructions = {
      make(Operation::for_prepare, 0, 3), make(Operation::reached),
      make(Operation::for_next, 0, 1), make(Operation::give_unknown)};
  Box loop[5] = {Box::small(2), Box::small(5), Box::small(1)};
  EXPECT_FALSE(FrameCheck(code, 1).find_broken_loop(loop));
  EXPECT_FALSE(FrameCheck(code, 2).find_broken_loop(loop));
  loop[0] = Box::small(-1);
  EXPECT_TRUE(FrameCheck(code, 1).find_broken_loop(loop));
  EXPECT_FALSE(FrameCheck(code, 0).find_broken_loop(loop));
  EXPECT_FALSE(FrameCheck(code, 3).find_broken_loop(loop));
  loop[0] = Box::small((std::int64_t{1} << 47) - 1);
  loop[2] = loop[0];
  EXPECT_TRUE(FrameCheck(code, 1).find_broken_loop(loop));
}

TEST(FrameCheck, AForEachWalksOverAList) {
  Code code;
  code.instructions = {make(Operation::each_prepare),
                       make(Operation::each_next, 0, 3),
                       make(Operation::reached), make(Operation::loop, 0, 2),
                       make(Operation::give_unknown)};
  Heap heap(nullptr, 1000);
  Box loop[4] = {make_list(heap), Box::small(0)};
  EXPECT_FALSE(FrameCheck(code, 2).find_broken_loop(loop));
  loop[1] = Box::small(-1);
  EXPECT_TRUE(FrameCheck(code, 3).find_broken_loop(loop));
  EXPECT_FALSE(FrameCheck(code, 4).find_broken_loop(loop));
  loop[0] = Box();
  EXPECT_TRUE(FrameCheck(code, 2).find_broken_loop(loop));
}

} // namespace

} // namespace parlour::script
