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

  void say(IpcKind kind, List fields) {
    ASSERT_TRUE(child->socket().send({kind, std::move(fields)}));
  }
  IpcMessage next() {
    while (messages.empty()) {
      child->wait();
      messages = child->socket().receive().value();
    }
    auto message = messages.front();
    messages.erase(messages.begin());
    return message;
  }
  void start() {
    EXPECT_EQ(next().kind, IpcKind::hello);
    say(IpcKind::start, {0, false, Map{}});
    EXPECT_EQ(next().kind, IpcKind::done);
  }
  void send(std::string command) {
    say(IpcKind::handle,
        {0, List{0, 0, "", std::move(command), List{}, List{}, "s", 3}});
  }

  std::unique_ptr<ChildProcess> child;
  std::vector<IpcMessage> messages;
};

TEST_F(ComponentServerTest, StopsAndEnds) {
  start();
  send("Echo");
  EXPECT_EQ(next().kind, IpcKind::fire);
  EXPECT_EQ(next().kind, IpcKind::done);
  say(IpcKind::stop, {0});
  EXPECT_EQ(next().kind, IpcKind::done);
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
  say(IpcKind::hello, {});
  EXPECT_EQ(child->bury(patience), "ended with status 1");
}

TEST_F(ComponentServerTest, CallsNoPluginThatThereIsNot) {
  EXPECT_EQ(next().kind, IpcKind::hello);
  send("Echo");
  EXPECT_TRUE(next().at(0).is_unknown());
  say(IpcKind::stop, {0});
  EXPECT_EQ(next().kind, IpcKind::done);
}

TEST(ComponentServer, RefusesWithItsReason) {
  int ends[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
  IpcSocket ours(ends[0]);
  EXPECT_EQ(refuse_component(ends[1], {ErrorKind::settings, "nobody", {}}), 1);
  const auto messages = ours.receive().value();
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_EQ(messages[0].kind, IpcKind::refuse);
  EXPECT_EQ(messages[0].at(0).at(1), Value("nobody"));
}

} // namespace
} // namespace parlour::adapters
