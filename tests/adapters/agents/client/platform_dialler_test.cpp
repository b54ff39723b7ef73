#include <future>

#include <gmock/gmock.h>

#include "adapters/agents/client/platform_dialler.hpp"
#include "tests/adapters/agents/agents_fixture.hpp"
#include "tests/support/start_loop.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::HasSubstr;

// Notes that something was heard.
class Listening : public PeerConnection::Owner, public Notes {
public:
  void heard(ConnectionId) override {}
  void arrived(ConnectionId, Read<AgentMessage>&& message) override {
    note(message ? message->command : message.error().sentence);
  }
  void lost(ConnectionId) override {
    note("lost");
  }
};

class PlatformDiallerTest : public AgentServerTest {
protected:
  ~PlatformDiallerTest() override {
    loop->post([this] {
      if (connection)
        connection->close();
      connection.reset();
    });
    loop->stop(Milliseconds(100));
  }
  // What became of it: empty, or why there is no connection.
  std::string dial(PlatformAddress address) {
    auto made = PlatformDialler::make(*loop, std::move(address));
    if (!made)
      return made.error().message;
    dialler = std::move(*made);
    std::promise<std::string> outcome;
    loop->post([&] {
      dialler->dial(1, listening, [&](PlatformDialler::Connected connected) {
        if (connected)
          connection = *connected;
        outcome.set_value(connected ? "" : connected.error().message);
      });
    });
    return outcome.get_future().get();
  }
  PlatformAddress address(bool is_zeromq) {
    const auto text = server->addresses().at(0);
    PlatformAddress address{"127.0.0.1", text.substr(text.rfind(':') + 1)};
    address.is_zeromq = is_zeromq;
    return address;
  }
  void say_hello() {
    loop->post([this] {
      connection->start();
      Hello hello;
      hello.name = "Robot";
      connection->write(hello_message(hello));
    });
    EXPECT_THAT(listening.wait_for(1), testing::ElementsAre("Welcome"));
  }

  Listening listening;
  std::unique_ptr<Loop> loop = test::start_loop();
  std::unique_ptr<PlatformDialler> dialler;
  std::shared_ptr<PeerConnection> connection;
};

TEST_F(PlatformDiallerTest, ConnectsByLines) {
  start({{}, LineOptions(), {}});
  EXPECT_EQ(dial(address(false)), "");
  say_hello();
}

TEST_F(PlatformDiallerTest, ConnectsByZeroMQ) {
  start({{}, {}, ServerOptions::ZeroMQ()});
  EXPECT_EQ(dial(address(true)), "");
  say_hello();
}

TEST_F(PlatformDiallerTest, SaysWhyThereIsNoConnection) {
  start({{}, LineOptions(), {}});
  const auto gone = address(false);
  server.reset();
  EXPECT_THAT(dial(gone), HasSubstr("refused"));
  PlatformAddress wrong{"no host", "none"};
  wrong.is_zeromq = true;
  EXPECT_THAT(dial(wrong), HasSubstr("no connection to tcp://no host:none"));
  EXPECT_THAT(dial({"localhost", "1", true, "none.pem"}),
              HasSubstr("none.pem"));
}

} // namespace
} // namespace parlour::adapters::agents
