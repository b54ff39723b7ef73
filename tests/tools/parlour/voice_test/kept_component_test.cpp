#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/fake_plugin_host.hpp"
#include "tests/tools/parlour/voice_test/fakes.hpp"
#include "tools/parlour/voice_test/kept_component.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;

// Counts what it got, and can be told to fail.
class Counter : public IPlugin {
public:
  explicit Counter(std::vector<std::string>& log) : log_(log) {}
  void stop() override {
    log_.emplace_back("stop");
  }

protected:
  Expected<void> on_start(const Options& options) override {
    if (options.contains("broken"))
      return fail(ErrorKind::settings, "broken");
    log_.emplace_back("start");
    return {};
  }
  void on_message(const Message& message) override {
    log_.push_back(message.command + " " + message.session);
    if (message.command == "Fail")
      host().failed("gone");
    fire_event("Done", {++count_});
  }

private:
  std::vector<std::string>& log_;
  std::int64_t count_ = 0;
};

class KeptComponentTest : public testing::Test {
protected:
  PluginFactory factory(const std::string& component = "Counter") {
    return kept.keep(component,
                     {{}, [this] { return std::make_unique<Counter>(log); }},
                     {message("Forget", "")});
  }
  static Message message(const std::string& command,
                         const std::string& session) {
    Message made;
    made.command = command;
    made.session = session;
    return made;
  }
  // A node: one instance, which gets one message. What it counted.
  std::string run(const std::string& command,
                  const std::string& of = "Counter") {
    test::FakePluginHost host;
    const auto component = factory(of).create();
    EXPECT_TRUE(component->start(host, {}));
    component->receive(message(command, "s1"));
    component->stop();
    return host.events.at(0).params.at(0).text();
  }

  std::vector<std::string> log;
  KeptComponents kept;
};

TEST_F(KeptComponentTest, goes_on_in_the_next_node) {
  EXPECT_EQ(run("One"), "1");
  EXPECT_EQ(run("Two"), "3"); // it was told to forget in between
  EXPECT_THAT(
      log, ElementsAre("start", "One s1", "Forget s1", "Two s1", "Forget s1"));
}

TEST_F(KeptComponentTest, serves_only_the_component_that_it_was_made_for) {
  EXPECT_EQ(run("One"), "1");
  EXPECT_EQ(run("One", "Other"), "1");
  EXPECT_EQ(run("Two"), "3");
}

TEST_F(KeptComponentTest, is_not_kept_once_it_has_failed) {
  EXPECT_EQ(run("Fail"), "1");
  EXPECT_EQ(run("Two"), "1");
  EXPECT_THAT(log, ElementsAre("start", "Fail s1", "Forget s1", "stop", "start",
                               "Two s1", "Forget s1"));
}

TEST_F(KeptComponentTest, is_not_kept_if_it_does_not_start) {
  test::FakePluginHost host;
  const auto component = factory().create();
  EXPECT_FALSE(component->start(host, {{"broken", "true"}}));
  component->stop();
  EXPECT_EQ(run("One"), "1");
}

TEST_F(KeptComponentTest, two_nodes_have_two) {
  test::FakePluginHost host;
  const auto one = factory().create();
  const auto two = factory().create();
  EXPECT_TRUE(one->start(host, {}));
  EXPECT_TRUE(two->start(host, {}));
  EXPECT_THAT(log, ElementsAre("start", "start"));
}

} // namespace
} // namespace parlour::tools
