#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/test_host.hpp"
#include "tools/parlour/application/plugins/plugin_calls.hpp"

namespace parlour::tools {
namespace {

// Throws where the option or the command says so.
class Thrower : public IPlugin {
public:
  void stop() override {
    throw std::runtime_error("it is stuck");
  }

protected:
  Expected<void> on_start(const Options& options) override {
    if (options.contains("throws"))
      throw std::runtime_error("no model");
    if (options.contains("fails"))
      return fail(ErrorKind::settings, "no voice");
    return {};
  }
  void on_message(const Message& message) override {
    if (message.command == "Throw")
      throw 7;
    fire_event("Done", {});
  }
};

class PluginCallsTest : public testing::Test {
protected:
  Expected<std::unique_ptr<IPlugin>> start(const Options& options = {}) {
    return start_plugin({{}, [] { return std::make_unique<Thrower>(); }}, host,
                        options);
  }
  static Message message(const std::string& command) {
    Message made;
    made.command = command;
    return made;
  }

  TestHost host;
};

TEST_F(PluginCallsTest, StartsSendsAndStops) {
  const auto plugin = start();
  ASSERT_TRUE(plugin);
  EXPECT_TRUE(send_to_plugin(**plugin, message("Do")));
  EXPECT_EQ(host.take_events().size(), 1u);
  EXPECT_NO_THROW(stop_plugin(**plugin));
}

TEST_F(PluginCallsTest, MakesAnErrorOfWhatIsThrown) {
  EXPECT_EQ(start({{"throws", ""}}).error().message, "it throws 'no model'");
  EXPECT_EQ(start({{"fails", ""}}).error().message, "no voice");
  const auto plugin = start();
  ASSERT_TRUE(plugin);
  const auto sent = send_to_plugin(**plugin, message("Throw"));
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().message, "it throws something");
}

TEST_F(PluginCallsTest, AFactoryMayThrow) {
  const auto made = start_plugin({{},
                                  []() -> std::unique_ptr<IPlugin> {
                                    throw std::runtime_error("no library");
                                  }},
                                 host, {});
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "it throws 'no library'");
}

} // namespace
} // namespace parlour::tools
