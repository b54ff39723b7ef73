#include <gtest/gtest.h>

#include "adapters/metrics/turn_metrics.hpp"
#include "runtime/plugin/conformance.hpp"
#include "tests/support/fake_plugin_host.hpp"

namespace parlour::adapters {
namespace {

class TurnMetricsTest : public testing::Test {
protected:
  TurnMetricsTest() {
    EXPECT_TRUE(metrics->start(host, {}));
    host.time.set(10'000);
  }
  void send(std::string command, std::vector<Value> params = {},
            std::string session = "s1") {
    Message message;
    message.command = std::move(command);
    message.params = std::move(params);
    message.session = std::move(session);
    metrics->receive(message);
  }

  test::FakePluginHost host;
  std::unique_ptr<IPlugin> metrics = turn_metrics_factory().create();
};

TEST_F(TurnMetricsTest, TellsTheTimesOfATurn) {
  send("TurnEnded", {4'000, 300});
  host.advance(Milliseconds(10));
  send("Recognised");
  send("Understood");
  send("Said", {7});
  host.advance(Milliseconds(20));
  send("Sounded", {7});
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].command, "Turn");
  EXPECT_EQ(host.events[0].session, "s1");
  EXPECT_EQ(to_string(host.events[0].params.at(0)),
            "{speech_end: 9700, decided: 300, recognised: 310, understood: "
            "310, said: 310, first_sound: 330}");
}

TEST_F(TurnMetricsTest, SessionsHaveTimesOfTheirOwn) {
  send("TurnEnded", {4'000, 300});
  send("Recognised");
  send("Said", {7});
  send("Sounded", {7}, "s2");
  EXPECT_TRUE(host.events.empty());
  send("Sounded", {7});
  EXPECT_EQ(host.events.size(), 1u);
}

TEST(TurnMetrics, KeepsTheContractOfItsRole) {
  const auto errors = conformance_errors(turn_metrics_factory(), {});
  EXPECT_TRUE(errors.empty()) << testing::PrintToString(errors);
}

} // namespace
} // namespace parlour::adapters
