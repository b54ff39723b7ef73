#include <array>

#include <gtest/gtest.h>

#include "script/program/host.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

TEST(Effect, AMissingOperandIsUnknown) {
  const std::array operands{Box::small(1), Box()};
  const Effect effect(EffectKind::print, operands);
  EXPECT_EQ(effect.operand(0), Value(1));
  EXPECT_TRUE(effect.operand(1).is_unknown());
  EXPECT_TRUE(effect.operand(2).is_unknown());
  EXPECT_TRUE(effect.has(0));
  EXPECT_FALSE(effect.has(1));
  EXPECT_FALSE(effect.has(2));
}

TEST(Effect, TextsAreWhatWouldBePrinted) {
  Heap heap({}, 1000);
  const std::array operands{Box::small(12), make_string(heap, "twelve")};
  const Effect effect(EffectKind::print, operands);
  EXPECT_EQ(effect.text(0), "12");
  EXPECT_EQ(effect.text(1), "twelve");
  EXPECT_EQ(effect.text(2), Value().text());
}

TEST(Effect, ReadsThroughBoundParameters) {
  Box variable = Box::small(3);
  const std::array operands{Box::reference(&variable)};
  const Effect effect(EffectKind::print, operands, operands);
  EXPECT_EQ(effect.text(0), "3");
  EXPECT_EQ(effect.captured(), std::vector<Value>{3});
}

} // namespace

} // namespace parlour::script
