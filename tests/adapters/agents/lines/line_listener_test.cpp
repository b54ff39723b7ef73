#include <optional>

#include <gmock/gmock.h>

#include "adapters/agents/lines/line_listener.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"
#include "tests/support/no_descriptors.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

using LineListenerTest = AgentServerTest;

TEST_F(LineListenerTest, SpeaksInLines) {
  start({{}, LineOptions(), {}});
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello,incarnation=aa");
  EXPECT_THAT(robot.hear(), StartsWith("welcome,,Parlour,Welcome,version=1"));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
  robot.say("text;n=1,,Robot,Arrived,lobby");
  EXPECT_THAT(component->wait_for(1), ElementsAre("Arrived"));
  EXPECT_EQ(robot.hear(), "ack;a=1");
  server->send("Robot", command("Goto"));
  EXPECT_EQ(robot.hear(), "text;n=1;a=1,,Robot,Goto");
  robot.say("shout");
  EXPECT_THAT(robot.hear(), HasSubstr("unknown"));
  robot.say("bye");
  EXPECT_THAT(component->wait_for(1), ElementsAre("offline"));
}

// What waits for an agent that does not read must not grow for ever.
TEST_F(LineListenerTest, EndsWhoDoesNotRead) {
  start({{}, LineOptions(), {}});
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello,incarnation=aa");
  component->wait_for(1);
  std::string many;
  for (int i = 0; i < 5000; ++i)
    many += "shout\nbeat\n";
  const auto talk = [&] {
    for (int i = 0; i < 400; ++i)
      robot.say(many);
  };
  EXPECT_ANY_THROW(talk());
  EXPECT_THAT(component->wait_for(1), ElementsAre("offline"));
  EXPECT_EQ(server->mistakes().at("flood"), 1U);
}

// Accepting fails at once while no file may be opened: it is not tried in each
// turn of the server, but again when there are files.
TEST_F(LineListenerTest, WaitsWhileTooManyFilesAreOpen) {
  start({{}, LineOptions(), {}});
  LineAgent robot(server->addresses().at(0));
  robot.say("hello,,Robot,Hello");
  robot.hear();
  asio::io_context context;
  asio::ip::tcp::socket socket(context, asio::ip::tcp::v4());
  auto none =
      std::make_optional<test::NoDescriptors>(socket.native_handle() + 1);
  socket.connect(robot.platform());
  EXPECT_THAT(log.wait_for(1), ElementsAre(HasSubstr("not accepted")));
  // Each answer takes at least a turn of the server.
  for (int i = 0; i < 500; ++i) {
    robot.say("beat\nshout");
    robot.hear();
  }
  EXPECT_LT(server->mistakes().at("accept"), 50U);
  none.reset();
  asio::write(socket, asio::buffer(std::string("hello,,Robot,Hello\n")));
  std::string held;
  asio::read_until(socket, asio::dynamic_buffer(held), '\n');
  EXPECT_THAT(held, StartsWith("welcome"));
}

} // namespace
} // namespace parlour::adapters::agents
