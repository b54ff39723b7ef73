// Servers that misbehave.
#include "tests/adapters/mqtt/mqtt_fixture.hpp"
#include "tests/adapters/network/listener.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string welcome("\x20\x02\x00\x00", 4);
const std::string ping("\xc0\x00", 2);

// A message of the server, quality of service 0.
std::string publication(const std::string& topic, const std::string& payload) {
  auto size = 2 + topic.size() + payload.size();
  std::string packet = "\x30";
  do {
    packet += static_cast<char>((size & 127) | (size > 127 ? 128 : 0));
    size >>= 7;
  } while (size > 0);
  packet += static_cast<char>(topic.size() >> 8);
  packet += static_cast<char>(topic.size() & 255);
  return packet + topic + payload;
}

class MQTTLinkTest : public MQTTTest {
protected:
  void TearDown() override {
    plugin = nullptr;
  }
  std::uint16_t port() const {
    const auto address = listener.address();
    return static_cast<std::uint16_t>(
        std::stoi(address.substr(address.find(':') + 1)));
  }
  void begin(const Options& more = {}) {
    auto all = options(port());
    for (const auto& [name, value] : more)
      all[name] = value;
    const auto started = start(all);
    ASSERT_TRUE(started) << started.error().message;
  }
  // Accepts the next connection, and its first packet.
  void accept() {
    listener.accept();
    const auto head = listener.receive(2);
    ASSERT_EQ(head.substr(0, 1), "\x10");
    listener.receive(static_cast<unsigned char>(head.at(1)));
  }
  void let_in() {
    accept();
    listener.send(welcome);
    ASSERT_TRUE(logs("connected to"));
    logged.clear();
  }

  test::Listener listener;
};

TEST_F(MQTTLinkTest, TriesAgainWhenTheServerClosesAtOnce) {
  begin();
  for (int i = 0; i < 4; ++i) {
    listener.accept();
    listener.hang_up();
  }
  EXPECT_TRUE(logs("cannot be reached"));
  EXPECT_TRUE(is_available(false));
  let_in();
  EXPECT_TRUE(is_available(true));
}

// The same reason again is no news.
TEST_F(MQTTLinkTest, LogsAReasonOnce) {
  begin();
  for (int i = 0; i < 5; ++i) {
    accept();
    listener.send(std::string("\x20\x02\x00\x04", 4));
    listener.hang_up();
  }
  accept();
  EXPECT_TRUE(logs("does not accept user and password"));
  EXPECT_EQ(std::ranges::count_if(logged,
                                  [](const std::string& line) {
                                    return line.find("cannot be reached") !=
                                           std::string::npos;
                                  }),
            1);
}

TEST_F(MQTTLinkTest, DoesNotWaitForEverForAWelcome) {
  begin({{"connect-timeout", "100ms"}});
  accept();
  EXPECT_TRUE(logs("it takes too long to connect"));
  listener.accept(); // it tries again
}

TEST_F(MQTTLinkTest, FailsWhatWaitsForAWelcomeThatDoesNotCome) {
  begin({{"connect-timeout", "300ms"}});
  accept();
  EXPECT_EQ(ask("lamp", "kitchen"), "Failed The devices' server cannot be "
                                    "reached: it takes too long to connect.");
}

TEST_F(MQTTLinkTest, GivesUpAServerThatTalksRubbish) {
  begin({{"connect-timeout", "300ms"}});
  accept();
  listener.send("HTTP/1.1 400 Bad Request\r\n\r\n");
  EXPECT_TRUE(logs("cannot be reached"));
  accept();
  listener.send(std::string(1'000, '\xff'));
  accept();
  listener.send(std::string("\x20\x02\x00\x09", 4)); // there is no such answer
  let_in();
}

TEST_F(MQTTLinkTest, BearsALossInTheMiddle) {
  begin();
  let_in();
  const auto packet = publication("lamp/s", std::string(10'000, 'x'));
  listener.send(packet.substr(0, 5'000));
  listener.hang_up();
  EXPECT_TRUE(logs("cannot be reached"));
  let_in();
  listener.break_off();
  EXPECT_TRUE(logs("cannot be reached"));
  let_in();
}

// What the server says bit by bit is read all the same.
TEST_F(MQTTLinkTest, ReadsWhatComesInPieces) {
  folder.write("devices.tsv", "device\troom\tkind\tstate_topic\n"
                              "thermometer\thall\tsensor\tt\n");
  begin();
  let_in();
  for (const char byte : publication("t", "21"))
    listener.send({byte});
  EXPECT_EQ(next(), "unasked State thermometer hall 21");
}

// Several messages in one piece, also behind the welcome.
TEST_F(MQTTLinkTest, ReadsWhatComesTogether) {
  folder.write("devices.tsv", "device\troom\tkind\tstate_topic\n"
                              "thermometer\thall\tsensor\tt\n");
  begin();
  accept();
  listener.send(welcome + publication("t", "1") + publication("t", "2"));
  EXPECT_EQ(next(), "unasked State thermometer hall 1");
  EXPECT_EQ(next(), "unasked State thermometer hall 2");
}

TEST_F(MQTTLinkTest, ComplainsAboutWhatIsTooLong) {
  begin();
  let_in();
  listener.send(
      publication("x", std::string(DevicePolicy::max_payload + 1, 'x')));
  EXPECT_TRUE(logs("has 262145 bytes; it is ignored"));
  EXPECT_TRUE(host.is_available());
}

// It takes commands and never says that it has them.
TEST_F(MQTTLinkTest, DoesNotWaitForEverForReceipts) {
  folder.write("devices.tsv", "device\troom\tkind\tcommand_topic\n"
                              "lamp\thall\tlight\tc\n");
  begin({{"answer-timeout", "200ms"}});
  let_in();
  EXPECT_EQ(set("lamp", "hall", "on"),
            "Failed The lamp in the hall does not answer.");
}

TEST_F(MQTTLinkTest, FailsOrdersThatAreUnderWayWhenTheServerGoes) {
  folder.write("devices.tsv", "device\troom\tkind\tcommand_topic\n"
                              "lamp\thall\tlight\tc\n");
  begin();
  let_in();
  ASSERT_TRUE(logs("1 devices are known"));
  send("Set", {"lamp", "hall", "on"});
  listener.receive(66); // two subscriptions, and the beginning of the order
  listener.hang_up();
  EXPECT_THAT(next(),
              StartsWith("Failed The devices' server cannot be reached"));
}

// A server that does not read: commands wait, and fail; nothing grows.
TEST_F(MQTTLinkTest, BearsAServerThatDoesNotRead) {
  folder.write("devices.tsv", "device\troom\tkind\tcommand_topic\tpayload_on\n"
                              "lamp\thall\tlight\tc\t" +
                                  std::string(60'000, 'x') + "\n");
  begin({{"answer-timeout", "1s"}});
  let_in();
  ASSERT_TRUE(logs("1 devices are known"));
  for (int i = 0; i < 3'000; ++i)
    send("Set", {"lamp", "hall", "on"});
  int refused = 0;
  for (int i = 0; i < 3'000; ++i) {
    const auto answer = next();
    EXPECT_THAT(answer, StartsWith("Failed"));
    refused += answer == "Failed Too many wait for the devices." ? 1 : 0;
  }
  EXPECT_GE(refused, 1'000);
}

// Devices report without a pause, and nobody has an order: the server has to
// hear all the same that the link lives. Five seconds are the library's least.
TEST_F(MQTTLinkTest, SaysThatItIsThereWhileDevicesReport) {
  begin({{"keep-alive", "5s"}});
  let_in();
  std::string heard;
  for (int i = 0; i < 40 && !heard.ends_with(ping); ++i) {
    listener.send(publication("meter", "1"));
    heard += listener.receive_within(Milliseconds(500));
  }
  EXPECT_TRUE(heard.ends_with(ping));
}

TEST_F(MQTTLinkTest, StopsInAnyPhase) {
  begin();
  plugin = nullptr;
  begin();
  listener.accept();
  plugin = nullptr;
  begin();
  accept();
  plugin = nullptr;
  begin();
  listener.accept();
  listener.hang_up();
  plugin = nullptr;
  // With orders that nobody carries out.
  begin();
  send("Ask", {"lamp", "hall"});
  plugin->stop();
  EXPECT_THAT(next(), HasSubstr("the component is stopped"));
}

// The server hears a goodbye, and does not tell that a client was lost.
TEST_F(MQTTLinkTest, SaysGoodbye) {
  folder.write("devices.tsv", "device\troom\tkind\nlamp\t*\tlight\n");
  begin();
  let_in();
  plugin = nullptr;
  const auto all = listener.receive(1'000);
  EXPECT_TRUE(all.ends_with(std::string("\xe0\x00", 2)));
}

} // namespace
} // namespace parlour::adapters::mqtt
