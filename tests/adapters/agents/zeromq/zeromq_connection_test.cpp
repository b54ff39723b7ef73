#include <gmock/gmock.h>

#include "adapters/agents/client/agent_connection.hpp"
#include "adapters/agents/zeromq/zeromq_connection.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

// Notes what the platform says.
class NotingListener : public AgentConnection::Listener, public Notes {
public:
  void received(AgentMessage message) override {
    Notes::note(message.command + " " + std::to_string(size_of(message)));
    connection->handed_on();
  }
  void note(const std::string& text) override {
    Notes::note(text);
  }
  void offline() override {}
  void rejected(const Error& error) override {
    Notes::note(error.message);
  }

  AgentConnection* connection = nullptr;

private:
  static std::size_t size_of(const AgentMessage& message) {
    return message.parameters.empty() ? 0 : message.parameters.front().size();
  }
};

class ZeroMQConnectionTest : public AgentServerTest {
protected:
  std::unique_ptr<AgentConnection> connect(const KeyPair& own = {},
                                           const std::string& platform = {}) {
    Hello hello;
    hello.name = "Robot";
    const auto address = server->addresses().at(0);
    auto opened = AgentConnection::open({"127.0.0.1",
                                         address.substr(address.rfind(':') + 1),
                                         false, "", true, own, platform},
                                        hello, listener);
    EXPECT_TRUE(opened);
    listener.connection = opened->get();
    EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
    EXPECT_THAT(listener.wait_for(1), ElementsAre(HasSubstr("connected to")));
    return std::move(*opened);
  }
  static AgentMessage say(std::string what, std::size_t bytes) {
    auto message = command(std::move(what));
    message.parameters = {std::string(bytes, 'x')};
    return message;
  }

  NotingListener listener;
};

TEST_F(ZeroMQConnectionTest, CarriesMessagesBothWays) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  const auto agent = connect();
  server->send("Robot", say("Goto", 5));
  EXPECT_THAT(listener.wait_for(1), ElementsAre("Goto 5"));
  EXPECT_TRUE(agent->send(command("Arrived")));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Arrived"));
}

// Short ones are packed, long ones are not; what is between is neither lost nor
// late.
TEST_F(ZeroMQConnectionTest, KeepsTheOrderOfShortAndLong) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  const auto agent = connect();
  server->send("Robot", say("A", 1));
  server->send("Robot", say("B", 500'000));
  server->send("Robot", say("C", 2));
  EXPECT_THAT(listener.wait_for(3), ElementsAre("A 1", "B 500000", "C 2"));
  agent->send(say("D", 1));
  agent->send(say("E", 500'000));
  agent->send(say("F", 70'000));
  agent->send(say("G", 60'000));
  EXPECT_THAT(component->wait_for(4), ElementsAre("D", "E", "F", "G"));
}

TEST_F(ZeroMQConnectionTest, CarriesMoreThanOneFrameHolds) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  const auto agent = connect();
  for (int i = 0; i < 900; ++i)
    ASSERT_TRUE(agent->send(say("Seen", 400)));
  EXPECT_THAT(component->wait_for(900), SizeIs(900));
}

TEST_F(ZeroMQConnectionTest, IsEncryptedByKeys) {
  const auto platform = new_key_pair().value();
  const auto own = new_key_pair().value();
  start({{},
         {},
         ServerOptions::ZeroMQ{
             "tcp://127.0.0.1:*", platform.secret_key, {own.public_key}}});
  const auto agent = connect(own, platform.public_key);
  EXPECT_TRUE(agent->send(command("Arrived")));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Arrived"));
}

TEST_F(ZeroMQConnectionTest, SaysGoodbyeBehindItsLastMessage) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  auto agent = connect();
  agent->send(command("Arrived"));
  agent.reset();
  EXPECT_THAT(component->wait_for(2), ElementsAre("Arrived", "offline"));
}

TEST_F(ZeroMQConnectionTest, NamesAnAddressThatIsWrong) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  Hello hello;
  hello.name = "Robot";
  const auto agent = AgentConnection::open(
      {"no host", "none", false, "", true, {}, ""}, hello, listener);
  ASSERT_TRUE(agent);
  EXPECT_THAT(listener.wait_for(1), ElementsAre(HasSubstr("not connected")));
}

} // namespace
} // namespace parlour::adapters::agents
