// Peers that mean harm: each gets an error or is disconnected, and is counted;
// nothing of it reaches the platform.
#include "tests/adapters/agents/delivery/exchange_fixture.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A byte each second: its parts come in time, but the hello does not.
TEST_F(AgentExchangeTest, HalfAHelloForeverEndsTheConnection) {
  open(1);
  const auto end = now + AgentExchange::hello_within.count();
  for (; now < end; now += 1000) {
    exchange.heard(1, now);
    exchange.tick(now);
    EXPECT_THAT(world.take(), IsEmpty());
  }
  exchange.heard(1, now);
  exchange.tick(now);
  EXPECT_THAT(world.take(), ElementsAre(HasSubstr("no hello"), "1 closed"));
  EXPECT_THAT(world.mistakes, ElementsAre("peer1: unknown"));
}

// Each would be an Online or an Offline for scripts.
TEST_F(AgentExchangeTest, AFloodOfHellosEndsTheConnection) {
  open(1);
  int hellos = 0;
  while (world.mistakes.empty() && ++hellos < 1000)
    say(1, "hello,,Robot,Hello");
  EXPECT_EQ(hellos, AgentExchange::max_hellos_per_second + 1);
  EXPECT_THAT(world.mistakes, ElementsAre("Robot: flood"));
  EXPECT_THAT(world.take(), Contains("1 closed"));
  // Nor does another connection help.
  open(2);
  say(2, "hello,,Robot,Hello");
  EXPECT_THAT(world.take(), ElementsAre(HasSubstr("flood"), "2 closed"));
  now += 1000;
  open(3);
  say(3, "hello,,Robot,Hello");
  EXPECT_THAT(world.take(), Contains("Robot online"));
}

// Who does not know the token cannot use up the agent's hellos.
TEST_F(AgentExchangeTest, AFloodOfOthersHellosDoesNotKeepTheAgentOut) {
  for (ConnectionId id = 1; id < 200; ++id) {
    open(id);
    say(id, "hello,,Arm,Hello,token=guess" + std::to_string(id));
  }
  EXPECT_EQ(world.mistakes.size(), 199U);
  world.take();
  open(200);
  say(200, "hello,,Arm,Hello,token=secret");
  EXPECT_THAT(world.take(), Contains("Arm online"));
}

TEST_F(AgentExchangeTest, NoMoreConnectionsThanThereMayBe) {
  for (ConnectionId id = 1; id <= AgentExchange::max_connections; ++id)
    open(id);
  EXPECT_THAT(world.take(), IsEmpty());
  const ConnectionId last = AgentExchange::max_connections + 1;
  open(last);
  EXPECT_THAT(world.take(), ElementsAre(HasSubstr("too many connections"),
                                        std::to_string(last) + " closed"));
}

// What was overheard and is said again on a connection of one's own is an agent
// that has forgotten all, not the one that was overheard: where that matters,
// there are keys and tokens.
TEST_F(AgentExchangeTest, AReplayedHelloDoesNotContinueTheOthersNumbers) {
  open(1);
  say(1, "hello,,Arm,Hello,token=secret,incarnation=aa");
  say(1, "text;n=1,,Arm,Moved");
  say(1, "text;n=1,,Arm,Moved"); // dropped: it was seen
  EXPECT_THAT(world.take(),
              ElementsAre(HasSubstr("welcome"), "Arm online", "Arm: Moved"));
  open(2);
  say(2, "hello,,Arm,Hello,token=overheard,incarnation=aa,seen=bb:0");
  say(2, "text;n=2,,Arm,Moved");
  EXPECT_THAT(world.take(), ElementsAre(HasSubstr("identity"), "2 closed"));
  say(1, "text;n=2,,Arm,Moved");
  EXPECT_THAT(world.take(), ElementsAre("Arm: Moved"));
}

// Well-formed on the wire, but nobody can read what it says.
TEST_F(AgentExchangeTest, MistakesWithinMessagesCountAsOthers) {
  connect(1);
  for (int i = 1; i <= AgentExchange::max_malformed; ++i)
    say(1, "text;c=" + std::to_string(i) + ",,Robot,Garbled");
  const auto notes = world.take();
  EXPECT_THAT(notes.front(), HasSubstr("1< error;c=1,,Parlour,malformed"));
  EXPECT_THAT(notes, Contains(HasSubstr("error;c=10,,Parlour,flood")));
  EXPECT_THAT(notes.back(), "Robot offline");
}

} // namespace
} // namespace parlour::adapters::agents
