#include <future>

#include <asio/ip/tcp.hpp>
#include <gtest/gtest.h>

#include "adapters/http/webhooks/webhook_connection.hpp"
#include "adapters/loop/loop.hpp"
#include "tests/adapters/http/webhooks/client.hpp"
#include "tests/support/start_loop.hpp"

namespace parlour::adapters::http {
namespace {

using asio::ip::tcp;

class WebhookConnectionTest : public testing::Test {
protected:
  WebhookConnectionTest()
      : acceptor_(loop_->context(),
                  tcp::endpoint(asio::ip::address_v4::loopback(), 0)),
        client("http://127.0.0.1:" +
               std::to_string(acceptor_.local_endpoint().port())) {
    connection = std::make_shared<WebhookConnection>(
        acceptor_.accept(), make_request_parser(100),
        [this](const WebhookRequest& request) {
          ++judged;
          return request.path == "/" ? 422 : 204;
        },
        [this] { over.set_value(); });
  }
  ~WebhookConnectionTest() override {
    loop_->stop();
  }

  void start(Milliseconds patience = Milliseconds(20'000)) {
    loop_->post([this, patience] { connection->start(patience); });
  }

private:
  const std::unique_ptr<Loop> loop_ = test::start_loop();
  tcp::acceptor acceptor_;

protected:
  test::Client client;
  std::shared_ptr<WebhookConnection> connection;
  std::atomic<int> judged = 0;
  // Throws if it is said twice.
  std::promise<void> over;
};

TEST_F(WebhookConnectionTest, AnswersOneRequest) {
  start();
  client.send(test::post("/", "a") + test::post("/other", "b"));
  EXPECT_EQ(client.status(), 422);
  EXPECT_EQ(judged, 1);
}

TEST_F(WebhookConnectionTest, EndsWithItsSender) {
  start();
  client.send("POST");
  client.shut();
  over.get_future().wait();
  EXPECT_EQ(judged, 0);
}

TEST_F(WebhookConnectionTest, EndsWhenItsPatienceDoes) {
  start(Milliseconds(20));
  over.get_future().wait();
  EXPECT_EQ(client.receive_all(), "");
}

} // namespace
} // namespace parlour::adapters::http
