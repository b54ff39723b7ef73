#include <future>

#include <asio/ip/tcp.hpp>
#include <gtest/gtest.h>

#include "adapters/http/server/request_connection.hpp"
#include "adapters/loop/loop.hpp"
#include "tests/support/start_loop.hpp"
#include "tests/support/tcp_client.hpp"

namespace parlour::adapters::http {
namespace {

using asio::ip::tcp;

class RequestConnectionTest : public testing::Test {
protected:
  RequestConnectionTest()
      : acceptor_(loop_->context(),
                  tcp::endpoint(asio::ip::address_v4::loopback(), 0)),
        client("http://127.0.0.1:" +
               std::to_string(acceptor_.local_endpoint().port())) {
    answerer.answer = [this](const ReceivedRequest& request) {
      ++answered;
      return Reply{request.path == "/" ? 422 : 204};
    };
  }
  ~RequestConnectionTest() override {
    loop_->stop();
  }

  void start(Milliseconds patience = Milliseconds(20'000)) {
    RequestConnection::Socket socket(loop_->context());
    acceptor_.accept(socket);
    connection = std::make_shared<RequestConnection>(
        std::move(socket), make_request_parser(100), answerer, patience,
        [this] { over.set_value(); });
    loop_->post([this] { connection->start(); });
  }

private:
  const std::unique_ptr<Loop> loop_ = test::start_loop();
  StandaloneAsio::Acceptor acceptor_;

protected:
  test::Client client;
  Answerer answerer;
  std::shared_ptr<RequestConnection> connection;
  std::atomic<int> answered = 0;
  // Throws if it is said twice.
  std::promise<void> over;
};

TEST_F(RequestConnectionTest, AnswersOneRequest) {
  start();
  client.send(test::post("/", "a") + test::post("/other", "b"));
  EXPECT_EQ(client.status(), 422);
  EXPECT_EQ(answered, 1);
}

TEST_F(RequestConnectionTest, AnswersWhatIsNoRequest) {
  start();
  client.send("hello\r\n\r\n");
  EXPECT_EQ(client.receive_all(),
            "HTTP/1.1 400 Bad Request\r\nContent-Length: 0\r\n"
            "Connection: close\r\n\r\n");
  EXPECT_EQ(answered, 0);
}

TEST_F(RequestConnectionTest, TheAnswererHasWordsForWhatIsNoRequest) {
  answerer.refuse = [](int status) {
    return Reply{status, "no", "text/plain"};
  };
  start();
  client.send("hello\r\n\r\n");
  EXPECT_EQ(client.receive_all(),
            "HTTP/1.1 400 Bad Request\r\nContent-Type: text/plain\r\n"
            "Content-Length: 2\r\nConnection: close\r\n\r\nno");
}

TEST_F(RequestConnectionTest, EndsWithItsSender) {
  start();
  client.send("POST");
  client.shut();
  over.get_future().wait();
  EXPECT_EQ(answered, 0);
}

TEST_F(RequestConnectionTest, EndsWhenItsPatienceDoes) {
  start(Milliseconds(20));
  over.get_future().wait();
  EXPECT_EQ(client.receive_all(), "");
}

// Whoever has got the answer is let go, although the connection stays open on
// its side.
TEST_F(RequestConnectionTest, EndsIfTheOtherSideNeverCloses) {
  start(Milliseconds(50));
  client.send(test::post("/other", "b"));
  EXPECT_EQ(client.status(), 204);
  over.get_future().wait();
}

} // namespace
} // namespace parlour::adapters::http
