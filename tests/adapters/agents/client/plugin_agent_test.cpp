#include <atomic>
#include <thread>

#include <gmock/gmock.h>

#include "adapters/agents/client/plugin_agent.hpp"
#include "adapters/agents/component/remote_agent.hpp"
#include "runtime/plugin/test_host.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"

namespace parlour::adapters::agents {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

// Arrives at once, wherever it is to go; throws at "the moon", breaks at "sea".
class Walker : public IPlugin {
protected:
  Expected<void> on_start(const Options& options) override {
    if (options.contains("early"))
      throw std::runtime_error("it is too early");
    if (options.contains("lame"))
      return fail(ErrorKind::settings, "it is lame");
    return {};
  }
  void on_message(const Message& message) override {
    const auto place = message.params.at(0).text();
    if (place == "the moon")
      throw std::runtime_error("too far");
    if (place == "sea")
      host().failed("it is wet");
    fire_event("Arrived", {place, 7});
  }
};

// A walker in a process of its own, as far as a thread can be one, and its
// component here.
class PluginAgentTest : public testing::Test {
protected:
  PluginAgentTest() {
    ServerOptions options;
    options.accounts.push_back({"Porter", "", ""});
    options.lines = LineOptions();
    server = std::move(*AgentServer::start(std::move(options)));
    plugin = remote_agent({"Porter", {"Robot"}, 8s}, server).create();
    EXPECT_TRUE(plugin->start(host, {}));
  }
  ~PluginAgentTest() override {
    if (agent)
      agent->stop();
    if (thread.joinable())
      thread.join();
    plugin->stop();
  }

  PluginAgentOrder order(Options options = {}) {
    PluginAgentOrder made;
    made.name = "Porter";
    const auto address = server->addresses().at(0);
    made.address = {"127.0.0.1", address.substr(address.rfind(':') + 1), false,
                    ""};
    made.factory.description.roles = {"Robot"};
    made.factory.create = [] { return std::make_unique<Walker>(); };
    made.options = std::move(options);
    made.log = [](const std::string&) {};
    return made;
  }
  void begin() {
    agent.emplace(order());
    thread = std::thread([this] { outcome = agent->run(); });
    EXPECT_TRUE(host.wait([&] { return host.is_available(); }, 10s));
  }
  void go(const std::string& place) {
    Message message;
    message.source = "Script";
    message.command = "Goto";
    message.params = {place};
    message.sinks = {"Robot"};
    message.session = "ann";
    message.correlation = 5;
    plugin->receive(message);
  }

  std::shared_ptr<AgentServer> server;
  TestHost host;
  std::unique_ptr<IPlugin> plugin;
  std::optional<PluginAgent> agent;
  std::thread thread;
  Expected<void> outcome;
};

TEST_F(PluginAgentTest, APluginAnswersFromElsewhere) {
  begin();
  go("kitchen");
  std::vector<Message> events;
  EXPECT_TRUE(
      host.wait([&] { return !(events = host.take_events()).empty(); }, 10s));
  EXPECT_EQ(to_string(events.at(0)), "Porter.Arrived(kitchen, 7)");
  EXPECT_EQ(events[0].params[1], Value(7));
  EXPECT_EQ(events[0].session, "ann");
  EXPECT_EQ(events[0].correlation, 5u);
}

TEST_F(PluginAgentTest, StopsWithoutAnError) {
  begin();
  agent->stop();
  thread.join();
  EXPECT_TRUE(outcome);
  EXPECT_TRUE(host.wait([&] { return !host.is_available(); }, 10s));
}

TEST_F(PluginAgentTest, EndsWithThePlugin) {
  begin();
  go("the moon");
  thread.join();
  ASSERT_FALSE(outcome);
  EXPECT_THAT(outcome.error().message, HasSubstr("too far"));
}

TEST_F(PluginAgentTest, SaysWhatThePluginThrowsAtItsStart) {
  const auto done = PluginAgent(order({{"early", "yes"}})).run();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().kind, ErrorKind::thrown);
  EXPECT_EQ(done.error().message, "it is too early");
}

TEST_F(PluginAgentTest, SaysWhatThePluginThrowsAtItsEnd) {
  struct Clinging : Walker {
    void stop() override {
      throw std::runtime_error("it wants to stay");
    }
  };
  auto clinging = order();
  clinging.factory.create = [] { return std::make_unique<Clinging>(); };
  PluginAgent one(std::move(clinging));
  one.stop();
  const auto done = one.run();
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().message, "it wants to stay");
}

TEST_F(PluginAgentTest, EndsWhereThePluginSaysThatItIsBroken) {
  begin();
  go("sea");
  thread.join();
  ASSERT_FALSE(outcome);
  EXPECT_THAT(outcome.error().message, HasSubstr("wet"));
}

TEST_F(PluginAgentTest, SaysWhyItDoesNotStart) {
  const auto failed = PluginAgent(order({{"lame", "yes"}})).run();
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("lame"));
  auto stranger = order();
  stranger.name = "Stranger";
  const auto rejected = PluginAgent(std::move(stranger)).run();
  ASSERT_FALSE(rejected);
  EXPECT_THAT(rejected.error().message, HasSubstr("identity"));
}

} // namespace
} // namespace parlour::adapters::agents
