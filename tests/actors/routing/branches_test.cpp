#include <gtest/gtest.h>

#include "actors/routing/branches.hpp"

namespace parlour::actors {
namespace {

TEST(Branches, KnowsEachSessionsOwn) {
  Branches branches;
  const auto one = std::make_shared<ComponentMailbox>();
  const auto other = std::make_shared<ComponentMailbox>();
  const auto up = std::make_shared<std::atomic<bool>>(true);
  branches.put("a", {one, up});
  branches.put("b", {other, up});
  EXPECT_EQ(branches.find("a")->mailbox, one);
  EXPECT_EQ(branches.find("b")->mailbox, other);
  EXPECT_FALSE(branches.find("c"));
  EXPECT_FALSE(branches.find(""));
  branches.remove("a");
  EXPECT_FALSE(branches.find("a"));
}

} // namespace
} // namespace parlour::actors
