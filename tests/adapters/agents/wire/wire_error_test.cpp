#include <gtest/gtest.h>

#include "adapters/agents/wire/wire_error.hpp"

namespace parlour::adapters::agents {
namespace {

TEST(WireError, SomeCloseTheConnection) {
  EXPECT_EQ(name_of(WireErrorKind::malformed), "malformed");
  EXPECT_FALSE(closes_connection({WireErrorKind::malformed, "why"}));
  EXPECT_TRUE(closes_connection({WireErrorKind::oversized, "why"}));
  EXPECT_TRUE(closes_connection({WireErrorKind::malformed, "why", true}));
  EXPECT_EQ(malformed("why").value(),
            (WireError{WireErrorKind::malformed, "why"}));
}

TEST(WireError, KindsHaveNames) {
  EXPECT_EQ(error_kind_of("malformed"), WireErrorKind::malformed);
  EXPECT_EQ(error_kind_of(name_of(WireErrorKind::flood)), WireErrorKind::flood);
  EXPECT_EQ(error_kind_of("of a later version"), std::nullopt);
}

// A sentence with half a character could not be sent.
TEST(Excerpt, NeverSplitsACharacter) {
  EXPECT_EQ(excerpt("short"), "short");
  EXPECT_EQ(excerpt("a\u00e9", 2), "a");
  EXPECT_EQ(excerpt("a\u20acb", 4), "a\u20ac");
}

} // namespace
} // namespace parlour::adapters::agents
