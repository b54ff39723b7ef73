#include <gtest/gtest.h>

#include "actors/support/chance.hpp"

namespace parlour::actors {
namespace {

TEST(Chance, RepeatsItselfFromASeed) {
  Chance one(7);
  Chance other(7);
  EXPECT_EQ(one.session_id(), other.session_id());
  EXPECT_EQ(one.session_seed(), 7u);
}

TEST(Chance, GivesIdsThatDiffer) {
  Chance chance(std::nullopt);
  auto id = chance.session_id();
  EXPECT_EQ(id.size(), 32u);
  EXPECT_NE(id, chance.session_id());
}

} // namespace
} // namespace parlour::actors
