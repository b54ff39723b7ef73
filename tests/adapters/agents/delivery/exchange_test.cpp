#include <gmock/gmock.h>

#include "tests/adapters/agents/delivery/exchange_fixture.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(AgentExchangeTest, WelcomesAnAgent) {
  open(1);
  say(1, "hello,,Robot,Hello,incarnation=aa");
  EXPECT_THAT(
      world.take(),
      ElementsAre("1< welcome,,Parlour,Welcome,version=1,incarnation=bb,"
                  "seen=aa:0,window=1000",
                  "Robot online"));
  EXPECT_TRUE(exchange.is_online("Robot"));
}

TEST_F(AgentExchangeTest, CarriesMessagesBothWays) {
  connect(1);
  say(1, "text;n=1,,Robot,Arrived,lobby");
  EXPECT_THAT(world.take(), ElementsAre("Robot: Arrived"));
  ASSERT_TRUE(exchange.send("Robot", command("Goto"), now));
  EXPECT_THAT(world.take(), ElementsAre("1< text;n=1;a=1,,Robot,Goto"));
}

TEST_F(AgentExchangeTest, RefusesMessagesWhileNobodyIsThere) {
  const auto sent = exchange.send("Robot", command("Goto"), now);
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().kind, ErrorKind::offline);
  EXPECT_FALSE(exchange.send("Nobody", command("Goto"), now));
}

TEST_F(AgentExchangeTest, SendsTheRestToWhoReturns) {
  connect(1);
  ASSERT_TRUE(exchange.send("Robot", command("Goto"), now));
  world.take();
  exchange.closed(1);
  EXPECT_THAT(world.take(), IsEmpty());
  EXPECT_TRUE(exchange.is_online("Robot"));
  ASSERT_TRUE(exchange.send("Robot", command("Grasp"), now));
  open(2);
  say(2, "hello,,Robot,Hello,incarnation=aa,seen=bb:0");
  EXPECT_THAT(world.take(),
              ElementsAre(HasSubstr("incarnation=bb"), "Robot online",
                          "2< text;n=1,,Robot,Goto",
                          "2< text;n=2,,Robot,Grasp"));
}

TEST_F(AgentExchangeTest, WhoDoesNotReturnSoonIsOffline) {
  connect(1);
  exchange.closed(1);
  now = *exchange.next_tick();
  exchange.tick(now - 1);
  EXPECT_THAT(world.take(), IsEmpty());
  exchange.tick(now);
  EXPECT_THAT(world.take(), ElementsAre("Robot offline"));
}

TEST_F(AgentExchangeTest, APersonWhoHangsUpIsOfflineAtOnce) {
  open(1);
  say(1, "hello,,Robot,Hello");
  world.take();
  exchange.closed(1);
  EXPECT_THAT(world.take(), ElementsAre("Robot offline"));
}

TEST_F(AgentExchangeTest, AnotherProcessMeansThatTheFormerHasEnded) {
  connect(1);
  exchange.closed(1);
  open(2);
  say(2, "hello,,Robot,Hello,incarnation=cc");
  EXPECT_THAT(world.take(), ElementsAre("Robot offline", HasSubstr("welcome"),
                                        "Robot online"));
}

// Whoever asked was told that the robot is gone: it must not walk later.
TEST_F(AgentExchangeTest, ARequestThatHasEndedIsNotCarriedOutLater) {
  connect(1);
  auto request = command("Goto");
  request.deadline = 10'000;
  ASSERT_TRUE(exchange.send("Robot", command("Say"), now));
  ASSERT_TRUE(exchange.send("Robot", std::move(request), now));
  ASSERT_TRUE(exchange.send("Robot", command("Release"), now));
  exchange.closed(1);
  now = *exchange.next_tick();
  exchange.tick(now); // offline
  world.take();
  open(2);
  say(2, "hello,,Robot,Hello,incarnation=aa,seen=bb:1");
  auto notes = world.take();
  EXPECT_THAT(notes, ElementsAre(HasSubstr("welcome"), "Robot online",
                                 "2< text;n=2", "2< text;n=3,,Robot,Release"));
  exchange.closed(2);
  open(3);
  say(3, "hello,,Robot,Hello,incarnation=cc");
  notes = world.take();
  EXPECT_EQ(notes.back(), "3< text;n=1,,Robot,Release");
}

TEST_F(AgentExchangeTest, NothingIsSaidBeforeHello) {
  open(1);
  say(1, "text,,Robot,Arrived,lobby");
  EXPECT_THAT(world.take(), ElementsAre(HasSubstr("unknown")));
  now += AgentExchange::hello_within.count();
  exchange.tick(now);
  EXPECT_THAT(world.take(), ElementsAre(HasSubstr("no hello"), "1 closed"));
}

TEST_F(AgentExchangeTest, ANewConnectionReplacesTheOldOne) {
  connect(1);
  open(2);
  say(2, "hello,,Robot,Hello,incarnation=aa");
  const auto notes = world.take();
  EXPECT_THAT(notes[0], HasSubstr("1< error,,Parlour,replaced"));
  EXPECT_THAT(notes[1], "1 closed");
  EXPECT_THAT(notes[2], "Robot offline");
  EXPECT_THAT(notes.back(), "Robot online");
  say(1, "text,,Robot,Arrived"); // of the old one: nobody's
  EXPECT_THAT(world.take(), IsEmpty());
}

TEST_F(AgentExchangeTest, KnowsWhoIsWho) {
  const auto refused = [&](ConnectionId id, const std::string& hello,
                           std::optional<std::string> key = {}) {
    open(id, std::move(key));
    say(id, hello);
    const auto notes = world.take();
    return notes.size() == 2 && notes[0].find("identity") != notes[0].npos &&
           notes[1] == std::to_string(id) + " closed";
  };
  EXPECT_TRUE(refused(1, "hello,,Stranger,Hello"));
  EXPECT_TRUE(refused(2, "hello,,Arm,Hello"));
  EXPECT_TRUE(refused(3, "hello,,Arm,Hello,token=guess"));
  EXPECT_FALSE(refused(4, "hello,,Arm,Hello,token=secret"));
  EXPECT_TRUE(refused(5, "hello,,Eye,Hello", "another"));
  EXPECT_FALSE(refused(6, "hello,,Eye,Hello", "key"));
}

TEST_F(AgentExchangeTest, NobodySpeaksForAnother) {
  connect(1);
  say(1, "text;n=1,,Arm,Arrived");
  const auto notes = world.take();
  EXPECT_THAT(notes[0], HasSubstr("identity"));
  EXPECT_THAT(notes[1], "1 closed");
  EXPECT_THAT(world.mistakes, ElementsAre("Robot: identity"));
  connect(2);
  say(2, "hello,,Arm,Hello,token=secret");
  EXPECT_THAT(world.take()[0], HasSubstr("identity"));
}

TEST_F(AgentExchangeTest, AnotherVersionIsAnswered) {
  open(1);
  say(1, "hello,,Robot,Hello,version=3");
  const auto notes = world.take();
  EXPECT_THAT(notes[0], HasSubstr("version"));
  EXPECT_THAT(notes[1], "1 closed");
}

TEST_F(AgentExchangeTest, ManyMalformedMessagesEndTheConnection) {
  connect(1);
  for (int i = 1; i < AgentExchange::max_malformed; ++i)
    say(1, "text,now,X,Y");
  EXPECT_EQ(world.take().size(), AgentExchange::max_malformed - 1);
  say(1, "text,now,X,Y");
  EXPECT_THAT(world.take(),
              ElementsAre(HasSubstr("flood"), "1 closed", "Robot offline"));
}

TEST_F(AgentExchangeTest, SilenceMeansOffline) {
  connect(1);
  for (int i = 0; i < 3; ++i) {
    now = *exchange.next_tick();
    exchange.tick(now);
  }
  EXPECT_THAT(world.take(),
              ElementsAre("1< beat", "1< beat", "1 closed", "Robot offline"));
}

TEST_F(AgentExchangeTest, AByeEndsTheConnection) {
  connect(1);
  say(1, "bye");
  EXPECT_THAT(world.take(), ElementsAre("1 closed", "Robot offline"));
}

TEST_F(AgentExchangeTest, RefusesWhatCannotBeWritten) {
  connect(1);
  auto message = command("Goto");
  message.session = "two words";
  EXPECT_EQ(exchange.send("Robot", std::move(message), now).error().kind,
            ErrorKind::limit);
}

// The first process must learn that the numbers begin again.
TEST_F(AgentExchangeTest, AnotherProcessInBetweenIsNoticed) {
  connect(1);
  ASSERT_TRUE(exchange.send("Robot", command("Goto"), now));
  say(1, "ack;a=1");
  open(2);
  say(2, "hello,,Robot,Hello,incarnation=cc");
  open(3);
  say(3, "hello,,Robot,Hello,incarnation=aa,seen=bb:1");
  world.take();
  open(4);
  say(4, "hello,,Robot,Hello,incarnation=aa,seen=bb:1");
  const auto notes = world.take();
  EXPECT_THAT(notes, testing::Contains(HasSubstr("4< welcome")));
  EXPECT_THAT(notes, testing::Not(testing::Contains(HasSubstr("=bb,"))));
}

TEST_F(AgentExchangeTest, WhoReturnsGoesOn) {
  connect(1);
  ASSERT_TRUE(exchange.send("Robot", command("Goto"), now));
  open(2);
  say(2, "hello,,Robot,Hello,incarnation=aa,seen=bb:1");
  EXPECT_THAT(world.take(),
              testing::Contains("2< welcome,,Parlour,Welcome,version=1,"
                                "incarnation=bb,seen=aa:0,window=1000"));
}

TEST_F(AgentExchangeTest, SaysThatNobodyTakesAMessage) {
  connect(1);
  say(1, "text;n=1;c=7,,Robot,Unwanted");
  EXPECT_THAT(world.take(),
              ElementsAre("1< error;c=7,,Parlour,refused,nobody takes it"));
  now += 100;
  exchange.tick(now);
  EXPECT_THAT(world.take(), ElementsAre("1< ack;a=1"));
}

TEST_F(AgentExchangeTest, GivesBackWhatWaitsForWhoStaysAway) {
  connect(1);
  ASSERT_TRUE(exchange.send("Robot", command("Goto"), now));
  exchange.closed(1);
  now = *exchange.next_tick();
  exchange.tick(now);
  EXPECT_EQ(world.take().back(), "Robot offline");
  now = *exchange.next_tick();
  exchange.tick(now - 1);
  EXPECT_THAT(world.take(), IsEmpty());
  exchange.tick(now);
  EXPECT_THAT(world.take(), ElementsAre("Robot: Goto given up, Offline"));
  EXPECT_FALSE(exchange.next_tick());
  open(2);
  say(2, "hello,,Robot,Hello,incarnation=aa,seen=bb:0");
  // A random one may begin with the same digits.
  const auto answers = world.take();
  EXPECT_THAT(answers, testing::Contains(HasSubstr("incarnation=")));
  EXPECT_THAT(answers, Not(testing::Contains(HasSubstr("incarnation=bb,"))));
}

TEST_F(AgentExchangeTest, EachTransportAsksForItsOwnCredential) {
  const auto admitted = [&](ConnectionId id, const std::string& hello,
                            std::optional<std::string> key) {
    open(id, std::move(key), true);
    say(id, hello);
    return testing::Matches(testing::Contains(HasSubstr("< welcome")))(
        world.take());
  };
  EXPECT_FALSE(admitted(1, "hello,,Robot,Hello", {}));
  EXPECT_FALSE(admitted(2, "hello,,Robot,Hello", "any"));
  EXPECT_TRUE(admitted(3, "hello,,Arm,Hello,token=secret", {}));
  EXPECT_FALSE(admitted(4, "hello,,Arm,Hello,token=secret", "any"));
  EXPECT_FALSE(admitted(5, "hello,,Eye,Hello", {}));
  EXPECT_TRUE(admitted(6, "hello,,Eye,Hello", "key"));
  EXPECT_TRUE(admitted(7, "hello,,Both,Hello,token=t", {}));
  EXPECT_TRUE(admitted(8, "hello,,Both,Hello", "k"));
  EXPECT_FALSE(admitted(9, "hello,,Both,Hello,token=k", {}));
}

TEST_F(AgentExchangeTest, AMalformedHelloEndsTheConnection) {
  open(1);
  say(1, "hello,,Robot,Hello,window=many");
  EXPECT_THAT(world.take(), ElementsAre(HasSubstr("malformed"), "1 closed"));
}

TEST_F(AgentExchangeTest, MistakesBeforeHelloAreCounted) {
  open(1);
  for (int i = 0; i < AgentExchange::max_malformed; ++i)
    say(1, "beat");
  EXPECT_THAT(world.take().back(), "1 closed");
  EXPECT_EQ(world.mistakes.front(), "peer1: unknown");
  EXPECT_EQ(world.mistakes.back(), "peer1: flood");
}

TEST_F(AgentExchangeTest, AByeAcknowledges) {
  connect(1);
  ASSERT_TRUE(exchange.send("Robot", command("Goto"), now));
  say(1, "bye;a=1");
  EXPECT_FALSE(exchange.next_tick()); // nothing waits
}

TEST_F(AgentExchangeTest, RefusesWhatItsNumbersWouldMakeTooLong) {
  connect(1);
  auto message = command("Goto");
  message.session = std::string(max_attribute_bytes - 10, 's');
  EXPECT_EQ(exchange.send("Robot", std::move(message), now).error().kind,
            ErrorKind::limit);
}

TEST_F(AgentExchangeTest, PartsOfAMessageEndTheSilence) {
  connect(1);
  now += Link::offline_after.count();
  exchange.heard(1, now);
  exchange.tick(now);
  EXPECT_TRUE(exchange.is_online("Robot"));
}

} // namespace
} // namespace parlour::adapters::agents
