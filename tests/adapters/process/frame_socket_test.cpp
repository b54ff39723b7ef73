#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include "adapters/process/frame_socket.hpp"

namespace parlour::adapters {
namespace {

class FrameSocketTest : public testing::Test {
protected:
  FrameSocketTest() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      throw std::runtime_error("no sockets");
    ours.emplace(ends[0]);
    theirs.emplace(ends[1]);
    other_end = ends[1];
  }

  static FrameSocket::Moment soon() {
    return FrameSocket::Moment::clock::now() + std::chrono::milliseconds(20);
  }

  std::optional<FrameSocket> ours;
  std::optional<FrameSocket> theirs;
  int other_end = -1;
};

TEST_F(FrameSocketTest, SendsAndReceives) {
  EXPECT_TRUE(ours->receive().value().empty());
  ASSERT_TRUE(theirs->send({FrameKind::log, {"one"}}));
  ASSERT_TRUE(theirs->send({FrameKind::log, {"two"}}));
  ours->wait();
  const auto frames = ours->receive().value();
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].at(0), Value("two"));
}

TEST_F(FrameSocketTest, SendsMoreThanTheSocketHolds) {
  const std::string text(longest_frame / 2, 'x');
  std::thread other([&] {
    EXPECT_TRUE(theirs->send({FrameKind::log, {text}}));
  });
  std::vector<Frame> frames;
  while (frames.empty()) {
    ours->wait();
    frames = ours->receive().value();
  }
  other.join();
  EXPECT_EQ(frames[0].at(0), Value(text));
}

TEST_F(FrameSocketTest, DoesNotWaitLongForWhoeverDoesNotRead) {
  const auto sent =
      ours->send({FrameKind::log, {std::string(8 << 20, 'x')}}, soon());
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().kind, ErrorKind::timeout);
}

TEST_F(FrameSocketTest, SeesThatTheOtherEndIsClosed) {
  ASSERT_TRUE(theirs->send({FrameKind::log, {"last"}}));
  theirs.reset();
  EXPECT_EQ(ours->receive().value().size(), 1u);
  ours->wait();
  EXPECT_EQ(ours->receive().error().kind, ErrorKind::offline);
  EXPECT_EQ(ours->send({FrameKind::log, {}}).error().kind, ErrorKind::offline);
}

TEST_F(FrameSocketTest, SaysThatItReadsRubbish) {
  ASSERT_EQ(write(other_end, "0123456789", 10), 10);
  EXPECT_EQ(ours->receive().error().kind, ErrorKind::network);
}

TEST_F(FrameSocketTest, ShutsDownForBoth) {
  ours->shut_down();
  EXPECT_EQ(ours->receive().error().kind, ErrorKind::offline);
  EXPECT_EQ(theirs->receive().error().kind, ErrorKind::offline);
}

TEST_F(FrameSocketTest, WaitsForAnotherDescriptorToo) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[1]);
  ours->wait(ends[0]); // returns, as it is closed
  close(ends[0]);
}

} // namespace
} // namespace parlour::adapters
