#include <gtest/gtest.h>

#include "adapters/agents/zeromq/key_pair.hpp"

namespace parlour::adapters::agents {
namespace {

TEST(KeyPair, IsNewEachTime) {
  const auto one = new_key_pair().value();
  const auto other = new_key_pair().value();
  EXPECT_EQ(one.public_key.size(), key_characters);
  EXPECT_EQ(one.secret_key.size(), key_characters);
  EXPECT_NE(one.public_key, one.secret_key);
  EXPECT_NE(one.secret_key, other.secret_key);
}

} // namespace
} // namespace parlour::adapters::agents
