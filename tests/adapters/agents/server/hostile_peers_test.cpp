// Peers that mean harm, by real connections: each gets an error or is
// disconnected, is counted and told in the log once a second at most; nothing
// of it reaches a component, and the other agents go on.
#include <gmock/gmock.h>

#include "runtime/base/random.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"
#include "tests/support/paths.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::AnyOf;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

// Says what it likes, and hears until the server closes the connection.
class HostilePeer {
public:
  explicit HostilePeer(const std::string& address) : socket_(context_) {
    const auto port = address.substr(address.rfind(':') + 1);
    socket_.connect({asio::ip::make_address("127.0.0.1"),
                     static_cast<asio::ip::port_type>(std::stoi(port))});
  }

  // As much of it as the server takes.
  void say(const std::string& bytes) {
    asio::error_code closed;
    asio::write(socket_, asio::buffer(bytes), closed);
  }
  // What the server has said before it closed the connection.
  std::string hear_to_the_end() {
    std::string heard;
    asio::error_code closed;
    asio::read(socket_, asio::dynamic_buffer(heard), closed);
    return heard;
  }

private:
  asio::io_context context_;
  asio::ip::tcp::socket socket_;
};

// An honest robot, and a porter that needs a token.
class HostilePeersTest : public AgentServerTest {
protected:
  void begin(ServerOptions options = {{}, LineOptions(), {}}) {
    options.accounts = {{"Porter", "secret", ""}};
    start(std::move(options));
    server->attach("Porter", porter);
    robot.emplace(server->addresses().at(0));
    robot->say("hello,,Robot,Hello");
    robot->hear();
    EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
  }
  // The honest robot is served, and nothing else has been heard of it.
  void expect_that_the_robot_is_served() {
    server->send("Robot", command("Goto"));
    EXPECT_THAT(robot->hear(), StartsWith("text;n=1"));
    robot->say("text,,Robot,Arrived");
    EXPECT_THAT(component->wait_for(1), ElementsAre("Arrived"));
  }

  std::shared_ptr<NotingComponent> porter = std::make_shared<NotingComponent>();
  std::optional<LineAgent> robot;
};

// Of the kinds of mistakes that may come of it there are few lines, however
// many mistakes there are.
TEST_F(HostilePeersTest, RandomBytes) {
  begin();
  Random random(7);
  for (int peer = 0; peer < 50; ++peer) {
    std::string bytes;
    for (int i = 0; i < 20'000; ++i)
      bytes += static_cast<char>(random.next() % (i % 2 == 0 ? 256 : 96) +
                                 (i % 2 == 0 ? 0 : 32));
    HostilePeer stranger(server->addresses().at(0));
    stranger.say(bytes + std::string(20, '\n') +
                 "x\nx\nx\nx\nx\nx\nx\nx\nx\nx\n");
    EXPECT_THAT(stranger.hear_to_the_end(),
                AnyOf(HasSubstr("flood"), HasSubstr("malformed"), ""));
  }
  expect_that_the_robot_is_served();
  std::uint64_t mistakes = 0;
  for (const auto& [kind, count] : server->mistakes())
    mistakes += count;
  EXPECT_GE(mistakes, 50U);
  EXPECT_LT(log.wait_for(1).size(), mistakes / 4);
}

TEST_F(HostilePeersTest, TruncatedMessages) {
  begin();
  for (const std::string part :
       {"hello,,Por", "hello,,Porter,Hello,token=sec",
        "hello,,Porter,Hello,token=secret\ntext;n=1,,Porter,Arr",
        "hello,,Porter,Hello,token=secret\nbinary;n=1,,Porter,Seen,png,"
        "9\n1234"})
    HostilePeer(server->addresses().at(0)).say(part);
  expect_that_the_robot_is_served();
  server->detach("Porter", porter.get());
  EXPECT_THAT(porter->wait_for(0), Each(AnyOf("Porter online", "offline")));
}

TEST_F(HostilePeersTest, ALineThatDoesNotEnd) {
  begin();
  HostilePeer stranger(server->addresses().at(0));
  stranger.say(std::string(3 << 20, 'a'));
  stranger.hear_to_the_end(); // its own bytes may keep it from the answer
  EXPECT_THAT(log.wait_for(1), ElementsAre(HasSubstr("oversized")));
  EXPECT_EQ(server->mistakes().at("oversized"), 1U);
  expect_that_the_robot_is_served();
}

TEST_F(HostilePeersTest, WrongTokensAndNames) {
  begin();
  for (const std::string hello :
       {"hello,,Porter,Hello,token=guess", "hello,,Porter,Hello",
        "hello,,Nobody,Hello", "hello,,,Hello"}) {
    HostilePeer stranger(server->addresses().at(0));
    stranger.say(hello + "\ntext;n=1,,Robot,Arrived\n");
    EXPECT_THAT(stranger.hear_to_the_end(), HasSubstr("identity")) << hello;
  }
  EXPECT_EQ(server->mistakes().at("identity"), 4U);
  EXPECT_THAT(log.wait_for(1), SizeIs(1));
  expect_that_the_robot_is_served();
}

TEST_F(HostilePeersTest, AnAgentThatSpeaksAsAnother) {
  begin();
  for (const std::string lie :
       {"text;n=1,,Robot,Arrived", "hello,,Robot,Hello"}) {
    HostilePeer liar(server->addresses().at(0));
    liar.say("hello,,Porter,Hello,token=secret\n" + lie + "\n");
    EXPECT_THAT(liar.hear_to_the_end(), HasSubstr("identity"));
    EXPECT_THAT(porter->wait_for(2), ElementsAre("Porter online", "offline"));
  }
  expect_that_the_robot_is_served();
}

// The numbers of 4.3, the messages without number of 4.1, and hellos.
TEST_F(HostilePeersTest, Floods) {
  begin();
  std::string unnumbered, hellos;
  for (int i = 0; i < 20'000; ++i) {
    unnumbered += "text,,Porter,Unwanted\n";
    hellos += "hello,,Porter,Hello,token=secret\n";
  }
  for (const auto& flood :
       {std::string("text;n=1001,,Porter,Moved\n"), unnumbered, hellos}) {
    HostilePeer peer(server->addresses().at(0));
    peer.say("hello,,Porter,Hello,token=secret\n" + flood);
    peer.hear_to_the_end();
  }
  EXPECT_EQ(server->mistakes().at("flood"), 3U);
  expect_that_the_robot_is_served();
  server->detach("Porter", porter.get());
  // Those of which the protocol allows so many in a second.
  EXPECT_LE(porter->wait_for(0).size(), 2000U);
}

TEST_F(HostilePeersTest, WhoDoesNotSpeakTLS) {
  const auto keys = test::source_path("tests/fixtures/tls/server");
  start(
      {{}, LineOptions{"127.0.0.1", 0, keys + ".pem", keys + "-key.pem"}, {}});
  HostilePeer stranger(server->addresses().at(0));
  stranger.say("hello,,Robot,Hello\n");
  stranger.hear_to_the_end();
  EXPECT_THAT(log.wait_for(1), ElementsAre(HasSubstr("no TLS")));
  EXPECT_EQ(server->mistakes().at("malformed"), 1U);
}

// What is wrong with a message by ZeroMQ, frame by frame.
TEST_F(HostilePeersTest, FramesThatAreNoMessage) {
  begin({{}, LineOptions(), ServerOptions::ZeroMQ()});
  FrameAgent stranger(server->addresses().at(1));
  stranger.say_frames({"parlour/2", "hello", "", "Robot", "Hello"});
  EXPECT_THAT(stranger.hear(), StartsWith("error,,Parlour,version"));
  stranger.say_frames({"parlour/1"});
  EXPECT_THAT(stranger.hear(), StartsWith("error,,Parlour,malformed"));
  stranger.say_frames({"parlour/1", "text", "", "Robot", "Arrived\xff"});
  EXPECT_THAT(stranger.hear(), StartsWith("error,,Parlour,malformed"));
  stranger.say_frames(std::vector<std::string>(5000, "parlour/1"));
  EXPECT_THAT(stranger.hear(), StartsWith("error"));
  stranger.say_frames(
      {"parlour/1", "text", "", "Robot", "Arrived", std::string(3 << 19, 'a')});
  EXPECT_THAT(stranger.hear(), StartsWith("error,,Parlour,oversized"));
  FrameAgent huge(server->addresses().at(1));
  huge.say_frames(
      {"parlour/1", "hello", "", "Robot", std::string(3 << 20, 'a')});
  FrameAgent next(server->addresses().at(1));
  next.say("beat");
  EXPECT_THAT(next.hear(), StartsWith("error,,Parlour,unknown"));
  expect_that_the_robot_is_served();
}

} // namespace
} // namespace parlour::adapters::agents
