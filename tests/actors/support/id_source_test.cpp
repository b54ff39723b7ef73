#include <gtest/gtest.h>

#include "actors/support/id_source.hpp"

namespace parlour::actors {
namespace {

TEST(IdSource, RepeatsItselfFromASeed) {
  IdSource one(7);
  IdSource other(7);
  EXPECT_EQ(one.session_id(), other.session_id());
  EXPECT_EQ(one.session_seed(), 7u);
}

TEST(IdSource, GivesIdsThatDiffer) {
  IdSource chance(std::nullopt);
  auto id = chance.session_id();
  EXPECT_EQ(id.size(), 32u);
  EXPECT_NE(id, chance.session_id());
}

} // namespace
} // namespace parlour::actors
