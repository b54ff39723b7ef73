#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "adapters/process/ipc_socket.hpp"

namespace parlour::adapters {
namespace {

class IpcSocketTest : public testing::Test {
protected:
  IpcSocketTest() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::runtime_error("no sockets");
    ours.emplace(ends[0]);
    theirs.emplace(ends[1]);
    other_end = ends[1];
  }

  static IpcSocket::Moment soon() {
    return IpcSocket::Moment::clock::now() + std::chrono::milliseconds(20);
  }

  std::optional<IpcSocket> ours;
  std::optional<IpcSocket> theirs;
  int other_end = -1;
};

TEST_F(IpcSocketTest, SendsAndReceives) {
  EXPECT_TRUE(ours->receive().value().empty());
  ASSERT_TRUE(theirs->send({IpcKind::log, {"one"}}));
  ASSERT_TRUE(theirs->send({IpcKind::log, {"two"}}));
  ours->wait();
  const auto messages = ours->receive().value();
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[1].at(0), Value("two"));
}

TEST_F(IpcSocketTest, SendsMoreThanTheSocketHolds) {
  const std::string text(longest_ipc_message / 2, 'x');
  std::thread other([&] { EXPECT_TRUE(theirs->send({IpcKind::log, {text}})); });
  std::vector<IpcMessage> messages;
  while (messages.empty()) {
    ours->wait();
    messages = ours->receive().value();
  }
  other.join();
  EXPECT_EQ(messages[0].at(0), Value(text));
}

TEST_F(IpcSocketTest, DoesNotWaitLongForWhoeverDoesNotRead) {
  const auto sent =
      ours->send({IpcKind::log, {std::string(8 << 20, 'x')}}, soon());
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().kind, ErrorKind::timeout);
}

TEST_F(IpcSocketTest, SeesThatTheOtherEndIsClosed) {
  ASSERT_TRUE(theirs->send({IpcKind::log, {"last"}}));
  theirs.reset();
  EXPECT_EQ(ours->receive().value().size(), 1u);
  ours->wait();
  EXPECT_EQ(ours->receive().error().kind, ErrorKind::offline);
  EXPECT_EQ(ours->send({IpcKind::log, {}}).error().kind, ErrorKind::offline);
}

TEST_F(IpcSocketTest, SaysThatItReadsRubbish) {
  ASSERT_EQ(write(other_end, "0123456789", 10), 10);
  EXPECT_EQ(ours->receive().error().kind, ErrorKind::network);
}

TEST_F(IpcSocketTest, ShutsDownForBoth) {
  ours->shut_down();
  EXPECT_EQ(ours->receive().error().kind, ErrorKind::offline);
  EXPECT_EQ(theirs->receive().error().kind, ErrorKind::offline);
}

TEST_F(IpcSocketTest, WaitsForAnotherDescriptorToo) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[1]);
  ours->wait(ends[0]); // returns, as it is closed
  close(ends[0]);
}

} // namespace
} // namespace parlour::adapters
