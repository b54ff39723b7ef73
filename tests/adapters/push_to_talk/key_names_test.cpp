#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/push_to_talk/key_names.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

// Codes as `evtest` shows them.
TEST(KeyNamesTest, KnowsTheKeysOfAKeyboard) {
  EXPECT_EQ(find_key("space"), (KeyName{57, ' '}));
  EXPECT_EQ(find_key("enter"), (KeyName{28, '\r'}));
  EXPECT_EQ(find_key("right-ctrl"), (KeyName{97, {}}));
  EXPECT_EQ(find_key("f1"), (KeyName{59, {}}));
  EXPECT_EQ(find_key("f10"), (KeyName{68, {}}));
  EXPECT_EQ(find_key("f12"), (KeyName{88, {}}));
  EXPECT_EQ(find_key("1"), (KeyName{2, '1'}));
  EXPECT_EQ(find_key("0"), (KeyName{11, '0'}));
  EXPECT_EQ(find_key("p"), (KeyName{25, 'p'}));
  EXPECT_EQ(find_key("m"), (KeyName{50, 'm'}));
}

TEST(KeyNamesTest, KnowsAnyKey) {
  EXPECT_EQ(find_key("any"), KeyName{});
  EXPECT_EQ(find_key("code-256"), (KeyName{256, {}}));
}

TEST(KeyNamesTest, RefusesOthers) {
  for (const auto* name : {"", "spacebar", "A", "f0", "f13", "f1x", "code-0",
                           "code-", "code-99999", "é"}) {
    const auto key = find_key(name);
    ASSERT_FALSE(key) << name;
    EXPECT_EQ(key.error().kind, ErrorKind::settings);
    EXPECT_THAT(key.error().message, HasSubstr("is no key; there are a to z"));
  }
}

} // namespace
} // namespace parlour::adapters
