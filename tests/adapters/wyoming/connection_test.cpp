#include <atomic>
#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/wyoming/connection.hpp"
#include "tests/adapters/wyoming/wyoming_server.hpp"
#include "tests/support/start_loop.hpp"

namespace parlour::adapters::wyoming {
namespace {

using testing::HasSubstr;
using Peer = test::WyomingServer::Peer;

class WyomingConnectionTest : public testing::Test {
protected:
  ~WyomingConnectionTest() override {
    loop->post([this] { connection.reset(); });
    loop->stop();
  }
  // Sends an event, and returns why the connection was closed in the end, or
  // the type of what was received.
  std::string outcome(int port, const Event& event) {
    std::promise<std::string> told;
    auto tell = [&, once = std::make_shared<bool>(false)](std::string text) {
      if (!std::exchange(*once, true))
        told.set_value(std::move(text));
    };
    route.address.port = std::to_string(port);
    loop->post([&] {
      connection = std::make_unique<Connection>(
          route, ConnectionCalls{[&, tell](Event one) { tell(one.type); },
                                 [&, tell](std::string why) { tell(why); }});
      connection->expect(Milliseconds(300));
      connection->send(event);
    });
    return told.get_future().get();
  }

  std::unique_ptr<Loop> loop = parlour::test::start_loop();
  Resolver resolver;
  Route route{*loop, resolver, {"127.0.0.1", ""}};
  std::unique_ptr<Connection> connection;
};

TEST_F(WyomingConnectionTest, sends_and_receives) {
  const test::WyomingServer server("", [](Peer& peer, const Event& event) {
    peer.send({"got " + event.type + " " + event.payload});
    return true;
  });
  EXPECT_EQ(outcome(server.port(), {"ping", {}, "abc"}), "got ping abc");
}

TEST_F(WyomingConnectionTest, slows_a_server_down_that_says_too_much) {
  constexpr std::size_t pieces = 100;
  std::atomic<std::size_t> sent = 0;
  const test::WyomingServer server("", [&](Peer& peer, const Event&) {
    for (; sent < pieces; ++sent)
      peer.send({"sound", {}, std::string(1 << 20, 'x')});
    return true;
  });
  std::promise<void> first;
  std::promise<void> last;
  std::size_t received = 0;
  route.address.port = std::to_string(server.port());
  loop->post([&] {
    connection = std::make_unique<Connection>(
        route, ConnectionCalls{[&](const Event&) {
                                 if (++received == 1) {
                                   connection->pause();
                                   first.set_value();
                                 }
                                 if (received == pieces)
                                   last.set_value();
                               },
                               [](const std::string&) {}});
    connection->send({"go"});
  });
  first.get_future().wait();
  // What is under way fits the system's buffers.
  EXPECT_LT(sent, pieces / 2);
  loop->post([&] { connection->resume(); });
  last.get_future().wait();
}

TEST_F(WyomingConnectionTest, says_why_it_has_ended) {
  auto server = std::make_unique<test::WyomingServer>(
      "", [](Peer& peer, const Event& event) {
        peer.write(event.payload);
        return event.type != "end";
      });
  EXPECT_THAT(outcome(server->port(), {"end"}), HasSubstr("has ended"));
  EXPECT_THAT(outcome(server->port(), {"end", {}, "{\"ty"}),
              HasSubstr("within an event"));
  EXPECT_THAT(outcome(server->port(), {"stay"}), HasSubstr("not answer"));
  EXPECT_THAT(outcome(server->port(), {"stay", {}, std::string(2 << 20, 'x')}),
              HasSubstr("too little"));
  const auto port = server->port();
  server.reset();
  EXPECT_THAT(outcome(port, {"end"}), HasSubstr("cannot be reached"));
}

} // namespace
} // namespace parlour::adapters::wyoming
