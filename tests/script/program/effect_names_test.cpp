#include <gtest/gtest.h>

#include "script/program/effect_names.hpp"

namespace parlour::script {

TEST(EffectNames, AreThoseOfTheElements) {
  EXPECT_EQ(element_of(EffectKind::wait), "wait");
  EXPECT_EQ(element_of(EffectKind::read_file), "readfile");
  EXPECT_EQ(element_of(EffectKind::fire_event), "fire");
  EXPECT_EQ(element_of(EffectKind::rollback), "transaction");
}

TEST(EffectNames, KnowWhatWaitsAndWhatLeadsElsewhere) {
  EXPECT_TRUE(waits(EffectKind::querydb));
  EXPECT_FALSE(waits(EffectKind::speak));
  EXPECT_TRUE(leads_elsewhere(EffectKind::transit));
  EXPECT_FALSE(leads_elsewhere(EffectKind::end));
}

TEST(EffectNames, KnowWhatCannotBeTakenBack) {
  EXPECT_EQ(deed_of(EffectKind::speak), Deed::yes);
  EXPECT_EQ(deed_of(EffectKind::list_files), Deed::no);
  EXPECT_EQ(deed_of(EffectKind::querydb), Deed::by_statement);
}

} // namespace parlour::script
