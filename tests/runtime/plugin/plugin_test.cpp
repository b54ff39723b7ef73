#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/plugin.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour {
namespace {

using namespace std::chrono_literals;
using test::FakePluginHost;
using test::message;
using testing::ElementsAre;

// Does what its messages say.
class Obedient : public IPlugin {
protected:
  Expected<void> on_start(const Options& options) override {
    if (options.count("broken"))
      return fail(ErrorKind::settings, "it is broken");
    return {};
  }

  void on_message(const Message& message) override {
    if (message.command == "Throw")
      throw std::runtime_error("thrown");
    if (message.command == "Later")
      host().after(1s, [this, message] { answer(message, "Done"); });
    else if (message.command == "LaterTwice")
      host().after(1s, [this, earlier = current()] {
        as_answer_to(earlier, [this] { fire_event("Done"); });
        fire_event("Unasked");
      });
    else if (message.command == "Nested")
      receive(test::message("Echo", {"inner"}, "s2", 8));
    else if (message.command == "Send")
      send_message(test::message("Goto", message.params));
    else if (message.command == "Ask")
      ask("Database", "Query", message.params, [this](const auto& answer) {
        fire_event(answer ? answer->command : answer.error().message);
      });
    else if (message.command == "Unasked")
      host().after(1s, [this] { fire_event("Pressed"); });
    if (message.command == "Echo" || message.command == "Nested")
      fire_event("Echoed", message.params);
  }
};

class Doubler : public InlinePlugin {
public:
  std::vector<Answer> answers(const Message& message) const override {
    return {{"Once", message.params}, {"Twice", message.params}};
  }
};

class PluginTest : public testing::Test {
protected:
  void SetUp() override {
    ASSERT_TRUE(plugin.start(host, {}));
  }

  FakePluginHost host;
  Obedient plugin;
};

TEST_F(PluginTest, AnswersWithSessionAndCorrelation) {
  plugin.receive(message("Echo", {"hello"}, "s9", 42));
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].command, "Echoed");
  EXPECT_THAT(host.events[0].params, ElementsAre(Value("hello")));
  EXPECT_EQ(host.events[0].session, "s9");
  EXPECT_EQ(host.events[0].correlation, 42u);
  EXPECT_EQ(host.events[0].source, "");
}

TEST_F(PluginTest, AnswersAnEarlierMessageLater) {
  plugin.receive(message("Later", {}, "s1", 1));
  plugin.receive(message("Echo", {}, "s2", 2));
  host.advance(999ms);
  EXPECT_EQ(host.events.size(), 1u);
  host.advance(1ms);
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_EQ(host.events[1].command, "Done");
  EXPECT_EQ(host.events[1].session, "s1");
  EXPECT_EQ(host.events[1].correlation, 1u);
}

TEST_F(PluginTest, FiresAsAnAnswerToAnEarlierMessageAsLongAsItSays) {
  plugin.receive(message("LaterTwice", {}, "s1", 1));
  host.advance(1s);
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_EQ(host.events[0].session, "s1");
  EXPECT_EQ(host.events[0].correlation, 1u);
  EXPECT_EQ(host.events[1].session, "");
}

TEST_F(PluginTest, FiresUnaskedWithoutSession) {
  plugin.receive(message("Unasked"));
  host.advance(1s);
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "");
  EXPECT_EQ(host.events[0].correlation, 0u);
}

TEST_F(PluginTest, ForgetsTheMessageWhenItsHandlerThrows) {
  EXPECT_THROW(plugin.receive(message("Throw")), std::runtime_error);
  plugin.receive(message("Unasked"));
  host.advance(1s);
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "");
}

TEST_F(PluginTest, KeepsTheOuterMessageWhenOneIsHandledWithin) {
  plugin.receive(message("Nested", {"outer"}, "s1", 7));
  ASSERT_EQ(host.events.size(), 2u);
  EXPECT_EQ(host.events[0].session, "s2");
  EXPECT_EQ(host.events[1].session, "s1");
  EXPECT_EQ(host.events[1].correlation, 7u);
}

TEST_F(PluginTest, SendsMessages) {
  plugin.receive(message("Send", {"kitchen"}));
  ASSERT_EQ(host.sent.size(), 1u);
  EXPECT_EQ(host.sent[0].command, "Goto");
  EXPECT_TRUE(host.events.empty());
}

TEST_F(PluginTest, AsksAnotherInTheSessionThatItServes) {
  plugin.receive(message("Ask", {"select 1"}, "s4"));
  ASSERT_EQ(host.asked.size(), 1u);
  const auto& [request, reaction] = host.asked[0];
  EXPECT_EQ(to_string(request), ".Query(select 1) -> Database");
  EXPECT_EQ(request.session, "s4");
  reaction(message("Result"));
  reaction(fail(ErrorKind::timeout, "late"));
  EXPECT_THAT(host.take_events(), ElementsAre("Result()", "late()"));
}

TEST(Plugin, RefusesToStartWithAReason) {
  FakePluginHost host;
  Obedient plugin;
  auto started = plugin.start(host, {{"broken", "true"}});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().message, "it is broken");
}

TEST(InlinePlugin, FiresItsAnswersInOrder) {
  FakePluginHost host;
  Doubler plugin;
  ASSERT_TRUE(plugin.start(host, {}));
  plugin.receive(message("Any", {1}, "s3", 5));
  EXPECT_THAT(host.take_events(), ElementsAre("Once(1)", "Twice(1)"));
}

TEST(InlinePlugin, IsAskedWithoutAHost) {
  const Doubler plugin;
  EXPECT_EQ(plugin.answers(message("Any")).size(), 2u);
}

} // namespace
} // namespace parlour
