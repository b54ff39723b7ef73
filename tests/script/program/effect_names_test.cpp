#include <gtest/gtest.h>

#include "script/program/effect_names.hpp"

namespace parlour::script {

TEST(EffectNames, AreThoseOfTheElements) {
  EXPECT_EQ(element_of(EffectKind::wait), "wait");
  EXPECT_EQ(element_of(EffectKind::read_file), "readfile");
  EXPECT_EQ(element_of(EffectKind::fire_event), "fire");
  EXPECT_EQ(element_of(EffectKind::rollback), "transaction");
}

} // namespace parlour::script
