#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/web/text_client.hpp"
#include "tests/adapters/web/fake_host.hpp"

namespace parlour::adapters::web {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

// Says hello and one turn, and stops the clients when it is over.
class Visitor : public Client {
public:
  explicit Visitor(TextClients& clients) : clients_(clients) {}
  void opened() override {
    link->send(R"({"type": "hello"})");
    link->send(R"({"type": "turn", "turn": 1, "say": "end"})");
  }
  void heard(const std::string& message) override {
    seen.push_back(message);
  }
  void closed(const std::string& why) override {
    seen.push_back(why);
    clients_.stop();
  }

  std::unique_ptr<ClientLink> link;
  std::vector<std::string> seen;

private:
  TextClients& clients_;
};

class TextClientTest : public testing::TestWithParam<TextClients::By> {
protected:
  TextClientTest() {
    auto started = TextServer::start({}, host, {});
    server = std::move(*started);
    host.teller = server.get();
    clients = std::move(*TextClients::start());
  }
  std::uint16_t port() const {
    const auto address = server->address();
    return static_cast<std::uint16_t>(
        std::stoi(address.substr(address.rfind(':') + 1)));
  }

  test::FakeHost<TextServer> host;
  std::unique_ptr<TextServer> server;
  std::unique_ptr<TextClients> clients;
};

TEST_P(TextClientTest, Visits) {
  Visitor visitor(*clients);
  visitor.link = clients->connect("127.0.0.1", port(), GetParam(), visitor);
  clients->run();
  ASSERT_EQ(visitor.seen.size(), 6);
  EXPECT_THAT(visitor.seen[0], HasSubstr("welcome"));
  EXPECT_THAT(visitor.seen[2], HasSubstr("echo: end"));
  EXPECT_EQ(visitor.seen[4], R"({"type": "end"})");
}

TEST_P(TextClientTest, SaysWhyItCannotConnect) {
  const auto closed = port();
  server = nullptr;
  Visitor visitor(*clients);
  visitor.link = clients->connect("127.0.0.1", closed, GetParam(), visitor);
  clients->run();
  EXPECT_THAT(visitor.seen, ElementsAre(HasSubstr("refused")));
}

TEST_P(TextClientTest, WhoIsDestroyedHearsNothing) {
  {
    Visitor visitor(*clients);
    visitor.link = clients->connect("127.0.0.1", port(), GetParam(), visitor);
  }
  std::vector<int> order;
  const auto now = std::chrono::steady_clock::now();
  clients->at(now + Milliseconds(2), [&] {
    order.push_back(2);
    clients->stop();
  });
  clients->at(now + Milliseconds(1), [&] { order.push_back(1); });
  clients->run();
  EXPECT_THAT(order, ElementsAre(1, 2));
}

INSTANTIATE_TEST_SUITE_P(ByBoth, TextClientTest,
                         testing::Values(TextClients::By::lines,
                                         TextClients::By::frames));

} // namespace
} // namespace parlour::adapters::web
