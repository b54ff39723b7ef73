#include <gmock/gmock.h>

#include "adapters/agents/delivery/outbox.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;

AgentMessage called(std::size_t number) {
  AgentMessage message;
  message.command = std::to_string(number);
  return message;
}

std::vector<std::string> commands(const std::vector<AgentMessage>& messages) {
  std::vector<std::string> all;
  for (const auto& message : messages)
    all.push_back(message.command);
  return all;
}

// The ring is gone through several times, and grows while its beginning is
// somewhere in the middle.
TEST(Outbox, KeepsTheOrder) {
  Outbox outbox;
  std::size_t added = 0;
  std::size_t taken = 0;
  for (std::size_t round = 0; round < 50; ++round) {
    for (std::size_t i = 0; i < 3 + round % 7; ++i)
      outbox.push_back(called(added++));
    for (std::size_t i = 0; i < 4 && !outbox.empty(); ++i) {
      EXPECT_EQ(outbox.front().command, std::to_string(taken++));
      outbox.pop_front();
    }
    ASSERT_EQ(outbox.size(), added - taken);
    for (std::size_t i = 0; i < outbox.size(); ++i)
      ASSERT_EQ(outbox[i].command, std::to_string(taken + i));
  }
}

TEST(Outbox, IsEmptiedAtOnce) {
  Outbox outbox;
  for (std::size_t i = 0; i < 6; ++i)
    outbox.push_back(called(i));
  outbox.pop_front();
  outbox.pop_front();
  for (std::size_t i = 6; i < 10; ++i)
    outbox.push_back(called(i));
  EXPECT_THAT(commands(outbox.take()),
              ElementsAre("2", "3", "4", "5", "6", "7", "8", "9"));
  EXPECT_TRUE(outbox.empty());
  outbox.push_back(called(1));
  EXPECT_EQ(outbox.front().command, "1");
}

TEST(Outbox, CanBeUsedAgainAfterMany) {
  Outbox outbox;
  for (std::size_t i = 0; i < 1000; ++i)
    outbox.push_back(called(i));
  while (!outbox.empty())
    outbox.pop_front();
  outbox.push_back(called(7));
  EXPECT_THAT(commands(outbox.take()), ElementsAre("7"));
}

} // namespace
} // namespace parlour::adapters::agents
