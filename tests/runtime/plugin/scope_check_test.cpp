#include <gtest/gtest.h>

#include "runtime/plugin/scope_check.hpp"

namespace parlour {
namespace {

TEST(ScopeCheck, SaysWhatAScopeIsNotFor) {
  using enum Scope::Kind;
  PluginDescription voice;
  voice.roles = {"TTS"};
  EXPECT_TRUE(check_scope({usual}, voice));
  EXPECT_TRUE(check_scope({node}, voice));
  EXPECT_TRUE(check_scope({pool, 4}, voice));
  EXPECT_FALSE(check_scope({in_turn}, voice));
  EXPECT_TRUE(check_scope({seat}, voice));
  EXPECT_TRUE(check_scope({session}, voice));
  auto words = voice;
  words.is_inline = true;
  EXPECT_TRUE(check_scope({in_turn}, words));
  auto shelf = voice;
  shelf.roles = {"Database"};
  EXPECT_FALSE(check_scope({pool, 2}, shelf));
  EXPECT_TRUE(check_scope({node}, shelf));
}

} // namespace
} // namespace parlour
