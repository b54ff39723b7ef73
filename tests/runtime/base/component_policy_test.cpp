#include <gtest/gtest.h>

#include "runtime/base/component_policy.hpp"

namespace parlour {
namespace {

TEST(ComponentPolicy, ReadsEveryScope) {
  using enum Scope::Kind;
  EXPECT_EQ(parse_scope("node"), Scope{node});
  EXPECT_EQ(parse_scope("seat"), Scope{seat});
  EXPECT_EQ(parse_scope("session"), Scope{session});
  EXPECT_EQ(parse_scope("inline"), Scope{in_turn});
  EXPECT_EQ(parse_scope("pool(1)"), (Scope{pool, 1}));
  EXPECT_EQ(parse_scope("pool(64)"), (Scope{pool, 64}));
  EXPECT_EQ(parse_scope("loaded"), (Scope{usual, 0})); // by scripts alone
  EXPECT_EQ(parse_scope("loaded session"), (Scope{session, 0}));
}

TEST(ComponentPolicy, KnowsNoOtherScope) {
  for (const auto* text : {"", "Node", "pool", "pool()", "pool(0)", "pool(65)",
                           "pool(-1)", "pool(2", "pool(2) ", "pool(2x)",
                           "loaded ", "loaded loaded", "loaded pool(2)"})
    EXPECT_EQ(parse_scope(text).error().kind, ErrorKind::settings) << text;
}

} // namespace
} // namespace parlour
