#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "adapters/loop/wait_until_ready.hpp"
#include "adapters/mqtt/mqtt_client.hpp"
#include "tests/adapters/network/listener.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::IsEmpty;

class MQTTClientTest : public testing::Test {
protected:
  MQTTClientTest() {
    signal(SIGPIPE, SIG_IGN);
    const auto address = listener.address();
    options.host = "127.0.0.1";
    options.port = static_cast<std::uint16_t>(
        std::stoi(address.substr(address.find(':') + 1)));
    options.client_id = "parlour";
    options.keep_alive = Milliseconds(60'000);
  }

  void SetUp() override {
    if (!MQTTClient::is_built_in())
      GTEST_SKIP() << "the program was built without libmosquitto";
  }

  // Drives the client until it is up or lost.
  static MQTTClient::Outcome drive(MQTTClient& client) {
    MQTTClient::Outcome outcome;
    while (outcome && !client.is_up())
      outcome = step(client);
    return outcome;
  }
  static MQTTClient::Outcome step(MQTTClient& client) {
    pollfd awaited[] = {{client.socket(), client.interest(), 0}};
    wait_until_ready(awaited);
    return client.proceed(awaited[0].revents);
  }

  ServerOptions options;
  test::Listener listener;
};

TEST_F(MQTTClientTest, LogsIn) {
  options.user = "me";
  options.password = "secret";
  MQTTClient client(options);
  ASSERT_TRUE(client.connect());
  listener.accept();
  listener.send(std::string("\x20\x02\x00\x00", 4));
  ASSERT_TRUE(drive(client));
  const auto head = listener.receive(2);
  const auto packet = listener.receive(static_cast<std::size_t>(head.at(1)));
  EXPECT_NE(packet.find("MQTT\x04"), std::string::npos);
  EXPECT_NE(packet.find("parlour"), std::string::npos);
  EXPECT_TRUE(packet.ends_with(std::string("\0\x02me\0\x06secret", 12)));
  EXPECT_TRUE(client.tend());
}

TEST_F(MQTTClientTest, SendsAndGetsMessages) {
  MQTTClient client(options);
  ASSERT_TRUE(client.connect());
  listener.accept();
  listener.send(std::string("\x20\x02\x00\x00", 4));
  ASSERT_TRUE(drive(client));
  const auto number = client.publish("a/b", "payload", true);
  ASSERT_TRUE(number);
  // The receipt of that number, and a retained message.
  listener.send({'\x40', '\x02', '\0', static_cast<char>(*number)});
  listener.send(std::string("\x31\x05\0\x01tON", 7));
  std::vector<Publication> got;
  std::vector<int> receipts;
  while (got.empty()) {
    ASSERT_TRUE(step(client));
    for (auto& one : client.publications())
      got.push_back(one);
    for (const auto one : client.receipts())
      receipts.push_back(one);
  }
  EXPECT_THAT(receipts, testing::ElementsAre(*number));
  EXPECT_EQ(got[0].topic, "t");
  EXPECT_EQ(got[0].payload, "ON");
  EXPECT_TRUE(got[0].retained);
  EXPECT_THAT(client.publications(), IsEmpty());
}

TEST_F(MQTTClientTest, SaysWhyItIsNotLetIn) {
  const char* reasons[] = {"the server does not speak MQTT 3.1.1",
                           "the server does not accept the client-id",
                           "the server is not ready",
                           "the server does not accept user and password",
                           "the server does not let this user in"};
  for (char code = 1; code <= 5; ++code) {
    MQTTClient client(options);
    ASSERT_TRUE(client.connect());
    listener.accept();
    listener.send({'\x20', '\x02', '\0', code});
    const auto outcome = drive(client);
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().kind, ErrorKind::network);
    EXPECT_EQ(outcome.error().message, reasons[code - 1]);
    EXPECT_FALSE(client.is_up());
  }
}

TEST_F(MQTTClientTest, SaysThatNobodyIsThere) {
  options.port = 1; // nobody listens there
  MQTTClient client(options);
  const auto begun = client.connect();
  const auto outcome = begun ? drive(client) : begun;
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().message, "Connection refused");
}

TEST_F(MQTTClientTest, NoticesALoss) {
  MQTTClient client(options);
  ASSERT_TRUE(client.connect());
  listener.accept();
  listener.send(std::string("\x20\x02\x00\x00", 4));
  ASSERT_TRUE(drive(client));
  listener.break_off();
  MQTTClient::Outcome outcome;
  while (outcome)
    outcome = step(client);
  EXPECT_FALSE(outcome.error().message.empty());
  // Whatever is asked of it later fails as well.
  EXPECT_FALSE(client.publish("a", "b", false));
  EXPECT_FALSE(client.subscribe("a"));
  EXPECT_FALSE(client.tend());
}

} // namespace
} // namespace parlour::adapters::mqtt
