#include <thread>

#include <gmock/gmock.h>

#include "adapters/agents/client/shared_link.hpp"

namespace parlour::adapters::agents {
namespace {

using namespace std::chrono_literals;

class SharedLinkTest : public testing::Test {
protected:
  void fill() {
    while (link.send(AgentMessage()))
      ++sent;
  }
  // The peer has received so many.
  void acknowledge(std::uint64_t number) {
    AgentMessage ack;
    ack.kind = MessageKind::ack;
    ack.acknowledged = number;
    EXPECT_FALSE(link.receive(ack, 0).error);
  }
  void write_all() {
    link.write_output(0, [](const AgentMessage&) {});
  }

  SharedLink link{"aa"};
  std::size_t sent = 0;
};

TEST_F(SharedLinkTest, RefusesWhatIsTooMuch) {
  fill();
  EXPECT_EQ(sent, Link::max_waiting);
  EXPECT_EQ(link.waiting(), Link::max_waiting);
  EXPECT_FALSE(link.wait_for_room(0ms));
}

TEST_F(SharedLinkTest, WakesWhoeverWaitsForRoom) {
  Introduction peer;
  peer.incarnation = "bb";
  peer.window = Link::max_waiting;
  link.connect(peer, 0);
  fill();
  write_all();
  std::thread author([this] {
    EXPECT_TRUE(link.wait_for_room(10s));
    EXPECT_TRUE(link.send(AgentMessage()));
  });
  acknowledge(Link::max_waiting / 4); // not enough
  EXPECT_FALSE(link.wait_for_room(0ms));
  acknowledge(Link::max_waiting);
  author.join();
  EXPECT_EQ(link.waiting(), 1u);
}

TEST_F(SharedLinkTest, SaysWhenManyAreToBeAcknowledged) {
  link.connect({"bb", "", 0, 100, false}, 0);
  AgentMessage message;
  message.command = "Goto";
  for (std::uint64_t number = 1; number <= Link::usual_window / 2; ++number) {
    message.number = number;
    ASSERT_TRUE(link.receive(message, 0).deliver);
    EXPECT_EQ(link.handed_on(), number == Link::usual_window / 2);
  }
}

} // namespace
} // namespace parlour::adapters::agents
