#include <gtest/gtest.h>

#include "runtime/message/inspection.hpp"

namespace parlour {
namespace {

TEST(Inspection, NamesTheSessionAndTheTurnThatItConcerns) {
  Inspection seen;
  EXPECT_EQ(concern_of(seen), "");
  seen.session = "s1";
  EXPECT_EQ(concern_of(seen), "  (session s1)");
  seen.turn = 3;
  EXPECT_EQ(concern_of(seen), "  (session s1, turn 3)");
}

} // namespace
} // namespace parlour
