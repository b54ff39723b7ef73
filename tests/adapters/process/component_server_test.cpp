#include <sys/socket.h>

#include "adapters/process/component_server.hpp"
#include "tests/adapters/process/process_fixture.hpp"

namespace parlour::adapters {
namespace {

// The process as it is, without a plug-in of ours before it.
class ComponentServerTest : public testing::Test {
protected:
  ComponentServerTest()
      : child(ChildProcess::spawn(trial().program, {}).value()) {}

  void say(FrameKind kind, List fields) {
    ASSERT_TRUE(child->socket().send({kind, std::move(fields)}));
  }
  Frame next() {
    while (frames.empty()) {
      child->wait();
      frames = child->socket().receive().value();
    }
    auto frame = frames.front();
    frames.erase(frames.begin());
    return frame;
  }
  void start() {
    EXPECT_EQ(next().kind, FrameKind::hello);
    say(FrameKind::start, {0, false, Map{}});
    EXPECT_EQ(next().kind, FrameKind::done);
  }
  void send(std::string command) {
    say(FrameKind::handle,
        {0, List{0, 0, "", std::move(command), List{}, List{}, "s", 3}});
  }

  std::unique_ptr<ChildProcess> child;
  std::vector<Frame> frames;
};

TEST_F(ComponentServerTest, StopsAndEnds) {
  start();
  send("Echo");
  EXPECT_EQ(next().kind, FrameKind::fire);
  EXPECT_EQ(next().kind, FrameKind::done);
  say(FrameKind::stop, {0});
  EXPECT_EQ(next().kind, FrameKind::done);
  child->socket().shut_down();
  EXPECT_EQ(child->bury(patience), "ended with status 0");
}

TEST_F(ComponentServerTest, EndsWithWhoeverStartedItWhateverThePluginDoes) {
  start();
  send("Hang");
  child->socket().shut_down();
  EXPECT_EQ(child->bury(patience), "ended with status 0");
}

TEST_F(ComponentServerTest, EndsWhereItIsSentRubbish) {
  start();
  say(FrameKind::hello, {});
  EXPECT_EQ(child->bury(patience), "ended with status 1");
}

TEST_F(ComponentServerTest, CallsNoPluginThatThereIsNot) {
  EXPECT_EQ(next().kind, FrameKind::hello);
  send("Echo");
  EXPECT_TRUE(next().at(0).is_unknown());
  say(FrameKind::stop, {0});
  EXPECT_EQ(next().kind, FrameKind::done);
}

TEST(ComponentServer, RefusesWithItsReason) {
  int ends[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  FrameSocket ours(ends[0]);
  EXPECT_EQ(refuse_component(ends[1], {ErrorKind::settings, "nobody", {}}), 1);
  const auto frames = ours.receive().value();
  ASSERT_EQ(frames.size(), 1u);
  EXPECT_EQ(frames[0].kind, FrameKind::refuse);
  EXPECT_EQ(frames[0].at(0).at(1), Value("nobody"));
}

} // namespace
} // namespace parlour::adapters
