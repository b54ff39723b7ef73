#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/network/tcp_sockets.hpp"
#include "tests/adapters/network/listener.hpp"
#include "tests/adapters/network/told.hpp"
#include "tests/support/no_descriptors.hpp"

namespace parlour::adapters {
namespace {

using namespace std::chrono_literals;
using test::Listener;
using test::Told;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

SocketOrder order(const std::string& address, bool lines = true) {
  return {address, lines, 60s};
}

TEST(TcpSockets, TalksToTheOtherSide) {
  Listener other;
  Told told;
  TcpSockets sockets;
  const auto id = sockets.open(order(other.address()), told.teller());
  other.accept();
  told.wait_for(1);
  ASSERT_TRUE(sockets.send(id, "hello\n"));
  EXPECT_EQ(other.receive(6), "hello\n");
  other.send("one\ntwo\nthree");
  told.wait_for(3);
  other.hang_up();
  EXPECT_THAT(told.wait_for(5),
              ElementsAre("opened", "text: one", "text: two", "text: three",
                          "closed: the other side closed it"));
  EXPECT_FALSE(sockets.send(id, "x"));
}

TEST(TcpSockets, ClosesAConnectionWhoseTellThrowsAndGoesOn) {
  Listener other;
  TcpSockets sockets;
  sockets.open(order(other.address()), [](const SocketEvent& event) {
    if (event.kind == SocketEvent::Kind::text)
      throw std::runtime_error("this is too much");
  });
  other.accept();
  other.send("one\n");
  EXPECT_EQ(other.receive(1), "") << "it is not closed";
  Told told;
  sockets.open(order(other.address()), told.teller());
  EXPECT_THAT(told.wait_for(1), ElementsAre("opened"));
}

TEST(TcpSockets, SaysWhyItIsNotOpened) {
  std::string address;
  {
    Listener nobody;
    address = nobody.address();
  }
  Told told;
  TcpSockets sockets;
  sockets.open(order(address), told.teller());
  EXPECT_EQ(told.wait_for(1)[0],
            "failed: no connection to " + address + ": Connection refused");
  sockets.open(order("no..such:80"), told.teller());
  EXPECT_THAT(told.wait_for(2)[1], HasSubstr("is not found"));
  sockets.open(order("nonsense"), told.teller());
  EXPECT_THAT(told.wait_for(3)[2], HasSubstr("write host:port"));
}

TEST(TcpSockets, OpensNothingWithoutDescriptors) {
  Told told;
  TcpSockets sockets;
  {
    const test::NoDescriptors none;
    sockets.open(order("127.0.0.1:1"), told.teller());
  }
  EXPECT_THAT(told.now(), ElementsAre("failed: no connection is possible: Too "
                                      "many open files"));
}

TEST(TcpSockets, ABrokenConnectionIsClosedWithItsReason) {
  Listener other;
  Told told;
  TcpSockets sockets;
  const auto id = sockets.open(order(other.address(), false), told.teller());
  other.accept();
  other.send("x");
  told.wait_for(2);
  other.break_off();
  EXPECT_THAT(told.wait_for(3)[2], StartsWith("closed: "));
  EXPECT_FALSE(sockets.send(id, "x"));
}

// Nothing is read while too much is not taken; the other side waits.
TEST(TcpSockets, WaitsUntilItsTextsAreTaken) {
  Listener other;
  Told told;
  TcpSockets sockets;
  const auto id = sockets.open(order(other.address()), told.teller());
  other.accept();
  told.wait_for(1);
  constexpr std::size_t much = 256 << 20;
  EXPECT_LT(other.fill(much), much);
  EXPECT_THAT(told.wait_for(17), SizeIs(17));
  sockets.taken(id);
  EXPECT_THAT(told.wait_for(18), SizeIs(18));
}

// The texts that wait come before the end.
TEST(TcpSockets, TellsAllBeforeItIsClosed) {
  Listener other;
  Told told;
  TcpSockets sockets;
  const auto id = sockets.open(order(other.address()), told.teller());
  other.accept();
  std::string text;
  for (int i = 0; i < 40; ++i)
    text += std::to_string(i) + "\n";
  other.send(text);
  other.hang_up();
  for (std::size_t i = 2; i <= 42; ++i) {
    const auto lines = told.wait_for(i);
    if (i < 42) {
      EXPECT_EQ(lines[i - 1], "text: " + std::to_string(i - 2));
    } else {
      EXPECT_THAT(lines.back(), StartsWith("closed"));
    }
    sockets.taken(id);
  }
}

TEST(TcpSockets, WhatNobodyTakesCannotBeSent) {
  Listener other(4096);
  Told told;
  TcpSockets sockets;
  const auto id = sockets.open(order(other.address()), told.teller());
  other.accept();
  told.wait_for(1);
  const std::string piece(256 << 10, 'x');
  Expected<void> sent;
  for (int i = 0; i < 1'000 && sent; ++i)
    sent = sockets.send(id, piece);
  ASSERT_FALSE(sent);
  EXPECT_THAT(sent.error().message, HasSubstr("does not take"));
}

TEST(TcpSockets, WhatWasSentLeavesBeforeItIsClosed) {
  Listener other;
  Told told;
  TcpSockets sockets;
  const auto id = sockets.open(order(other.address()), told.teller());
  other.accept();
  told.wait_for(1);
  const std::string text(900 << 10, 'x');
  ASSERT_TRUE(sockets.send(id, text));
  sockets.close(id);
  EXPECT_EQ(other.receive(text.size() + 1), text); // and then the end
  EXPECT_THAT(told.now(), ElementsAre("opened"));
}

TEST(TcpSockets, ManyShareOneThread) {
  Listener other;
  Told told;
  TcpSockets sockets;
  std::vector<Sockets::Id> ids;
  for (int i = 0; i < 100; ++i) {
    ids.push_back(sockets.open(order(other.address()), told.teller()));
    other.accept();
    other.send("x\n");
  }
  told.wait_for(200);
  for (auto id : ids)
    sockets.close(id);
}

TEST(TcpSockets, GoesWithWhatIsOpen) {
  Listener other;
  Told told;
  {
    TcpSockets sockets;
    sockets.open(order(other.address()), told.teller());
    other.accept();
    told.wait_for(1);
  }
  EXPECT_EQ(other.receive(1), "");
  TcpSockets unused;
}

} // namespace
} // namespace parlour::adapters
