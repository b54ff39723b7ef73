#include <gtest/gtest.h>

#include "actors/routing/instance_list.hpp"

namespace parlour::actors {
namespace {

TEST(InstanceList, KnowsEachSessionsOwn) {
  InstanceList instances;
  const auto one = std::make_shared<ComponentMailbox>();
  const auto other = std::make_shared<ComponentMailbox>();
  const auto up = std::make_shared<std::atomic<bool>>(true);
  instances.put("a", {one, up});
  instances.put("b", {other, up});
  EXPECT_EQ(instances.find("a")->mailbox, one);
  EXPECT_EQ(instances.find("b")->mailbox, other);
  EXPECT_FALSE(instances.find("c"));
  EXPECT_FALSE(instances.find(""));
  instances.remove("a");
  EXPECT_FALSE(instances.find("a"));
}

TEST(InstanceList, NamesTheSessionsOfThoseThatAreUp) {
  InstanceList instances;
  const auto mailbox = std::make_shared<ComponentMailbox>();
  const auto down = std::make_shared<std::atomic<bool>>(false);
  instances.put("a", {mailbox, std::make_shared<std::atomic<bool>>(true)});
  instances.put("b", {mailbox, down});
  EXPECT_EQ(instances.sessions(), std::vector<SessionId>{"a"});
}

} // namespace
} // namespace parlour::actors
