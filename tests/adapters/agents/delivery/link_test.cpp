#include <gmock/gmock.h>

#include "adapters/agents/delivery/link.hpp"
#include "runtime/base/random.hpp"
#include "tests/adapters/agents/delivery/link_output.hpp"

namespace parlour::adapters::agents {
namespace {

std::size_t below(Random& random, std::size_t end) {
  return static_cast<std::size_t>(random.next() % end);
}

using testing::ElementsAre;

// One end, and what it has received.
struct End {
  explicit End(std::string incarnation) : link(std::move(incarnation)) {}

  // False where the connection is to be closed.
  bool take(const AgentMessage& message, Timestamp now) {
    const auto arrival = link.receive(message, now);
    if (arrival.error)
      return false;
    if (arrival.deliver) {
      received.push_back(message.command);
      link.handed_on();
    }
    return true;
  }

  Link link;
  std::vector<std::string> received;
};

class LinkTest : public testing::Test {
protected:
  void connect() {
    const auto hello = robot.link.introduction();
    platform.link.connect(hello, now);
    robot.link.connect(platform.link.introduction(), now);
  }
  void disconnect() {
    platform.link.disconnect();
    robot.link.disconnect();
  }
  // Both ends write once, and what they write arrives.
  void exchange() {
    for (auto& message : output_of(platform.link, now))
      EXPECT_TRUE(robot.take(message, now));
    for (auto& message : output_of(robot.link, now))
      EXPECT_TRUE(platform.take(message, now));
  }

  Timestamp now = 1000;
  End platform{"platform"};
  End robot{"robot"};
};

TEST_F(LinkTest, DeliversInOrder) {
  connect();
  for (std::uint64_t i = 1; i <= 3; ++i)
    EXPECT_TRUE(platform.link.send(numbered(i)));
  exchange();
  EXPECT_THAT(robot.received, ElementsAre("1", "2", "3"));
  now += 100;
  exchange();
  EXPECT_EQ(platform.link.waiting(), 0U);
}

TEST_F(LinkTest, SendsAgainWhatWasLostWithAConnection) {
  connect();
  platform.link.send(numbered(1));
  exchange();
  platform.link.send(numbered(2));
  output_of(platform.link, now); // lost
  disconnect();
  platform.link.send(numbered(3));
  EXPECT_TRUE(output_of(platform.link, now).empty());
  connect();
  exchange();
  EXPECT_THAT(robot.received, ElementsAre("1", "2", "3"));
}

TEST_F(LinkTest, DropsWhatItHasSeen) {
  connect();
  platform.link.send(numbered(1));
  exchange();
  disconnect(); // before the acknowledgement
  connect();    // the hello tells
  exchange();
  EXPECT_THAT(robot.received, ElementsAre("1"));
  EXPECT_EQ(platform.link.waiting(), 0U);
}

TEST_F(LinkTest, NoticesAGap) {
  connect();
  platform.link.send(numbered(1));
  output_of(platform.link, now); // lost, though the connection stands
  platform.link.send(numbered(2));
  exchange();
  EXPECT_TRUE(robot.received.empty());
  exchange();
  EXPECT_THAT(robot.received, ElementsAre("1", "2"));
}

TEST_F(LinkTest, NoticesByABeatThatTheLastWasLost) {
  connect();
  platform.link.send(numbered(1));
  output_of(platform.link, now); // lost
  now += Link::beat_after.count();
  exchange(); // the beat, and the gap
  exchange();
  EXPECT_THAT(robot.received, ElementsAre("1"));
}

TEST_F(LinkTest, BeginsAfreshWithAnotherProcess) {
  connect();
  for (std::uint64_t i = 1; i <= 3; ++i)
    platform.link.send(numbered(i));
  output_of(platform.link, now); // lost with the process
  disconnect();
  robot = End("another robot");
  robot.link.send(numbered(7));
  connect();
  exchange();
  EXPECT_THAT(robot.received, ElementsAre("1", "2", "3"));
  EXPECT_THAT(platform.received, ElementsAre("7"));
}

TEST_F(LinkTest, SendsNoMoreThanTheWindow) {
  connect();
  for (std::uint64_t i = 1; i <= 250; ++i)
    ASSERT_TRUE(platform.link.send(numbered(i)));
  EXPECT_EQ(output_of(platform.link, now).size(), Link::usual_window);
  EXPECT_TRUE(output_of(platform.link, now).empty());
}

TEST_F(LinkTest, AcknowledgesOnlyWhatIsHandedOn) {
  connect();
  platform.link.send(numbered(1));
  for (auto& message : output_of(platform.link, now))
    EXPECT_TRUE(robot.link.receive(message, now).deliver);
  now += 2 * Link::beat_after.count();
  exchange();
  EXPECT_EQ(platform.link.waiting(), 1U);
  robot.link.handed_on();
  now += 2 * Link::beat_after.count();
  exchange();
  EXPECT_EQ(platform.link.waiting(), 0U);
}

TEST_F(LinkTest, RefusesWhatItsOutboxCannotHold) {
  for (std::size_t i = 0; i < Link::max_waiting; ++i)
    ASSERT_TRUE(platform.link.send(numbered(i)));
  EXPECT_FALSE(platform.link.send(numbered(0)));
  auto large = numbered(0);
  large.parameters = {std::string(Link::max_waiting_bytes, 'a')};
  EXPECT_FALSE(robot.link.send(std::move(large)));
}

TEST_F(LinkTest, EndsAFlood) {
  connect();
  auto message = numbered(1);
  message.number = Link::usual_window + 1;
  EXPECT_EQ(robot.link.receive(message, now).error->kind, WireErrorKind::flood);
}

TEST_F(LinkTest, AnswersAnAcknowledgementOfWhatWasNeverSent) {
  connect();
  AgentMessage ack;
  ack.kind = MessageKind::ack;
  ack.acknowledged = 5;
  EXPECT_EQ(robot.link.receive(ack, now).error->kind, WireErrorKind::malformed);
}

// It was sent before the gap was told.
TEST_F(LinkTest, TakesALateAcknowledgementAfterAGap) {
  connect();
  platform.link.send(numbered(1));
  platform.link.send(numbered(2));
  output_of(platform.link, now);
  AgentMessage gap;
  gap.kind = MessageKind::ack;
  gap.acknowledged = 0;
  gap.gap = true;
  EXPECT_FALSE(platform.link.receive(gap, now).error);
  AgentMessage ack;
  ack.kind = MessageKind::ack;
  ack.acknowledged = 2;
  EXPECT_FALSE(platform.link.receive(ack, now).error);
  EXPECT_EQ(platform.link.waiting(), 0U);
}

TEST_F(LinkTest, BeatsAndNoticesSilence) {
  connect();
  now = *robot.link.next_tick();
  EXPECT_EQ(output_of(robot.link, now).at(0).kind, MessageKind::beat);
  EXPECT_TRUE(robot.link.tick(now));
  now = 1000 + Link::offline_after.count();
  EXPECT_FALSE(robot.link.tick(now));
}

TEST_F(LinkTest, TakesMessagesWithoutNumbers) {
  connect();
  EXPECT_TRUE(platform.take(numbered(1), now));
  EXPECT_TRUE(platform.take(numbered(1), now));
  EXPECT_THAT(platform.received, ElementsAre("1", "1"));
}

// Thousands of messages each way, over connections that lose what they carry
// and break at any moment: all arrive, once, in order.
TEST_F(LinkTest, LosesNothingAndRepeatsNothing) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Random random(seed);
    platform = End("platform");
    robot = End("robot");
    constexpr std::size_t wanted = 500;
    std::size_t sent = 0;
    // One direction: what is written may be cut off, or lose its middle.
    const auto carry = [&](End& from, End& to) {
      auto output = output_of(from.link, now);
      const bool cut = below(random, 10) == 0;
      for (auto& message : output) {
        if (cut && below(random, 3) == 0)
          return false;
        if (below(random, 20) != 0) {
          EXPECT_TRUE(to.take(message, now));
        }
      }
      return true;
    };
    bool connected = false;
    while (platform.received.size() < wanted ||
           robot.received.size() < wanted) {
      ASSERT_LT(now, 1'000'000'000);
      now += static_cast<Timestamp>(below(random, 400));
      for (auto more = below(random, 20); more > 0 && sent < wanted; --more) {
        ++sent;
        ASSERT_TRUE(platform.link.send(numbered(sent)));
        ASSERT_TRUE(robot.link.send(numbered(sent)));
      }
      if (!connected)
        connect();
      connected = carry(platform, robot) && carry(robot, platform);
      connected = connected && robot.link.tick(now) && platform.link.tick(now);
      if (!connected)
        disconnect();
    }
    for (std::size_t i = 0; i < wanted; ++i) {
      ASSERT_EQ(platform.received[i], std::to_string(i + 1));
      ASSERT_EQ(robot.received[i], std::to_string(i + 1));
    }
    ASSERT_EQ(platform.received.size(), wanted);
    ASSERT_EQ(robot.received.size(), wanted);
  }
}

// What one process was told says nothing about another of the same name.
TEST_F(LinkTest, BeginsAfreshAfterAnotherProcessInBetween) {
  connect();
  platform.link.send(numbered(1));
  exchange();
  disconnect();
  const auto known = robot.link.introduction();
  EXPECT_TRUE(platform.link.goes_on_with(known));
  End other("other");
  platform.link.connect(other.link.introduction(), now);
  other.link.connect(platform.link.introduction(), now);
  platform.link.disconnect();
  EXPECT_FALSE(platform.link.goes_on_with(known));
}

TEST_F(LinkTest, BeginsAfreshWithAPeerThatHasForgotten) {
  connect();
  platform.link.send(numbered(1));
  exchange();
  now += 100;
  exchange();
  auto peer = robot.link.introduction();
  EXPECT_TRUE(platform.link.goes_on_with(peer));
  peer.seen_number = 0; // it had acknowledged 1
  EXPECT_FALSE(platform.link.goes_on_with(peer));
  EXPECT_FALSE(platform.link.is_behind(peer));
  peer.seen_number = 2; // never sent
  EXPECT_FALSE(platform.link.goes_on_with(peer));
  EXPECT_TRUE(platform.link.is_behind(peer));
  peer.seen_number = 1;
  peer.seen_incarnation = "another platform";
  EXPECT_FALSE(platform.link.goes_on_with(peer));
}

// The robot goes on talking: acknowledgements alone never tell it the number.
TEST_F(LinkTest, NoticesALostMessageWhileAcknowledgementsFlow) {
  connect();
  platform.link.send(numbered(1));
  output_of(platform.link, now); // lost
  for (std::uint64_t i = 1; i <= 30; ++i) {
    robot.link.send(numbered(i));
    now += 100;
    exchange();
  }
  EXPECT_THAT(robot.received, ElementsAre("1"));
}

TEST_F(LinkTest, PartsOfAMessageEndTheSilence) {
  connect();
  now += Link::offline_after.count() - 1;
  robot.link.heard(now);
  now += 1;
  EXPECT_TRUE(robot.link.tick(now));
}

TEST_F(LinkTest, AllowsAPersonToThink) {
  platform.link.connect({}, now);
  now += 100 * Link::offline_after.count();
  EXPECT_TRUE(platform.link.tick(now));
}

TEST_F(LinkTest, LimitsMessagesWithoutNumbers) {
  connect();
  for (int i = 0; i < Link::max_unnumbered_per_second; ++i)
    ASSERT_TRUE(robot.take(numbered(1), now));
  EXPECT_EQ(robot.link.receive(numbered(1), now).error->kind,
            WireErrorKind::flood);
  now += 1000;
  EXPECT_TRUE(robot.take(numbered(1), now));
}

TEST_F(LinkTest, ReadsTheWindow) {
  connect();
  platform.link.send(numbered(1));
  platform.link.send(numbered(2));
  platform.link.send(numbered(3));
  AgentMessage ack;
  ack.kind = MessageKind::ack;
  ack.acknowledged = 0;
  ack.window = 2;
  EXPECT_FALSE(platform.link.receive(ack, now).error);
  EXPECT_EQ(output_of(platform.link, now).size(), 2U);
}

TEST_F(LinkTest, AcknowledgesInTime) {
  connect();
  platform.link.send(numbered(1));
  exchange();
  // The owner's timer may be late by 50 ms.
  EXPECT_LE(*robot.link.next_tick() - now, 50);
}

TEST_F(LinkTest, GivesUpWhatWaits) {
  connect();
  platform.link.send(numbered(1));
  exchange();
  disconnect();
  EXPECT_EQ(platform.link.give_up().at(0).command, "1");
  EXPECT_EQ(platform.link.waiting(), 0U);
  EXPECT_FALSE(platform.link.goes_on_with(robot.link.introduction()));
}

TEST_F(LinkTest, WithdrawnRequestsAreCountedAndNotDelivered) {
  connect();
  auto request = numbered(2);
  request.deadline = 1000;
  platform.link.send(numbered(1));
  platform.link.send(std::move(request));
  platform.link.send(numbered(3));
  output_of(platform.link, now); // lost
  disconnect();
  platform.link.withdraw_requests();
  connect();
  exchange();
  EXPECT_THAT(robot.received, ElementsAre("1", "3"));
  now += 100;
  exchange();
  EXPECT_EQ(platform.link.waiting(), 0U);
}

TEST_F(LinkTest, ANewProcessGetsNoTraceOfThem) {
  connect();
  auto request = numbered(1);
  request.deadline = 1000;
  platform.link.send(std::move(request));
  platform.link.send(numbered(2));
  disconnect();
  platform.link.withdraw_requests();
  robot = End("another");
  connect();
  exchange();
  EXPECT_THAT(robot.received, ElementsAre("2"));
  EXPECT_EQ(platform.link.give_up().size(), 1U);
}

} // namespace
} // namespace parlour::adapters::agents
