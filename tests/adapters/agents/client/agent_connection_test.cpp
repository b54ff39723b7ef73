#include <fstream>

#include <gmock/gmock.h>

#include "adapters/agents/client/agent_connection.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

// Notes what the platform says.
class NotingListener : public AgentConnection::Listener, public Notes {
public:
  void received(AgentMessage message) override {
    if (message.command == "Explode")
      throw std::runtime_error("this is too much");
    Notes::note(message.command);
    if (connection)
      connection->handed_on();
  }
  void note(const std::string& text) override {
    Notes::note("note: " + text);
  }
  void offline() override {}
  void rejected(const Error& error) override {
    Notes::note("rejected: " + error.message);
  }

  AgentConnection* connection = nullptr;
};

class AgentConnectionTest : public AgentServerTest {
protected:
  AgentConnectionTest() {
    start({{}, LineOptions(), {}});
  }
  static PlatformAddress address_of(const std::string& text) {
    const auto colon = text.rfind(':');
    return {text.substr(6, colon - 6), text.substr(colon + 1), false, ""};
  }
  std::unique_ptr<AgentConnection> connect(const std::string& name) {
    Hello hello;
    hello.name = name;
    auto opened = AgentConnection::open(address_of(server->addresses().at(0)),
                                        hello, listener);
    EXPECT_TRUE(opened);
    listener.connection = opened->get();
    return std::move(*opened);
  }

  NotingListener listener;
};

TEST_F(AgentConnectionTest, CarriesMessagesBothWays) {
  const auto agent = connect("Robot");
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
  EXPECT_THAT(listener.wait_for(1), ElementsAre(HasSubstr("connected to")));
  server->send("Robot", command("Goto"));
  EXPECT_THAT(listener.wait_for(1), ElementsAre("Goto"));
  EXPECT_TRUE(agent->send(command("Arrived")));
  EXPECT_THAT(component->wait_for(1), ElementsAre("Arrived"));
}

TEST_F(AgentConnectionTest, EndsWithWhatItsListenerThrows) {
  const auto agent = connect("Robot");
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
  EXPECT_THAT(listener.wait_for(1), ElementsAre(HasSubstr("connected to")));
  server->send("Robot", command("Explode"));
  EXPECT_THAT(listener.wait_for(1), ElementsAre("rejected: this is too much"));
  EXPECT_THAT(component->wait_for(1), ElementsAre("offline"));
}

TEST_F(AgentConnectionTest, SaysGoodbyeBehindItsLastMessage) {
  auto agent = connect("Robot");
  component->wait_for(1);
  agent->send(command("Arrived"));
  agent.reset();
  EXPECT_THAT(component->wait_for(2), ElementsAre("Arrived", "offline"));
}

TEST_F(AgentConnectionTest, WhomThePlatformDoesNotWantStaysAway) {
  const auto agent = connect("Stranger");
  const auto notes = listener.wait_for(1);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("rejected: identity")));
}

TEST_F(AgentConnectionTest, ComesAndGoesAsItIsTold) {
  const auto agent = connect("Robot");
  component->wait_for(1);
  agent->set_present(false);
  EXPECT_THAT(component->wait_for(1), ElementsAre("offline"));
  agent->set_present(true);
  EXPECT_THAT(component->wait_for(1), ElementsAre("Robot online"));
}

TEST_F(AgentConnectionTest, NotesOnceThatNobodyListens) {
  const auto address = server->addresses().at(0);
  server.reset();
  Hello hello;
  hello.name = "Robot";
  const auto agent =
      AgentConnection::open(address_of(address), hello, listener);
  EXPECT_THAT(listener.wait_for(1), ElementsAre(HasSubstr("not connected")));
}

TEST_F(AgentConnectionTest, NamesACertificateThatCannotBeRead) {
  const auto opened =
      AgentConnection::open({"localhost", "1", true, "none.pem"}, {}, listener);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, HasSubstr("none.pem"));
}

} // namespace
} // namespace parlour::adapters::agents
