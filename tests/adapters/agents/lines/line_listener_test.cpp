#include <chrono>
#include <ctime>
#include <optional>
#include <thread>

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
  EXPECT_THAT(component->wait_for(2), ElementsAre("unknown", "offline"));
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
}

// Accepting fails at once while no file may be opened: it must not be tried
// again and again.
TEST_F(LineListenerTest, WaitsWhileTooManyFilesAreOpen) {
  start({{}, LineOptions(), {}});
  const auto address = server->addresses().at(0);
  asio::io_context context;
  asio::ip::tcp::socket socket(context, asio::ip::tcp::v4());
  auto none =
      std::make_optional<test::NoDescriptors>(socket.native_handle() + 1);
  const auto port = std::stoi(address.substr(address.rfind(':') + 1));
  socket.connect({asio::ip::make_address("127.0.0.1"),
                  static_cast<asio::ip::port_type>(port)});
  const auto before = std::clock();
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  const auto used = std::clock() - before;
  none.reset();
  EXPECT_LT(used, CLOCKS_PER_SEC / 20);
  asio::write(socket, asio::buffer(std::string("hello,,Robot,Hello\n")));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
}

} // namespace
} // namespace parlour::adapters::agents
