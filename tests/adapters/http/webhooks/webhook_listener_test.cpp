// Senders that behave and misbehave.
#include <future>
#include <mutex>
#include <vector>

#include <gmock/gmock.h>

#include "adapters/http/webhooks/webhook_listener.hpp"
#include "tests/support/tcp_client.hpp"

namespace parlour::adapters::http {
namespace {

using test::Client;
using test::post;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class WebhookListenerTest : public testing::Test {
protected:
  WebhookListenerTest() {
    options.listen = "127.0.0.1:0";
  }

  void start() {
    auto started = WebhookListener::start(
        options, [this](const auto& request) { return take(request); },
        [this](const std::string& what) { thrown.set_value(what); });
    ASSERT_TRUE(started) << started.error().message;
    listener = std::move(*started);
  }
  int take(const ReceivedRequest& request) {
    const std::lock_guard lock(mutex);
    if (request.path == "/bad")
      throw std::runtime_error("this is too much");
    taken.push_back(request.path + " " + request.body);
    return request.path == "/known" ? 204 : 404;
  }
  int send(const std::string& bytes) {
    Client client(listener->address());
    client.send(bytes);
    return client.status();
  }
  std::vector<std::string> all_taken() {
    const std::lock_guard lock(mutex);
    return taken;
  }

  ListenerOptions options;
  std::mutex mutex;
  std::vector<std::string> taken;
  std::promise<std::string> thrown;
  std::unique_ptr<WebhookListener> listener;
};

TEST_F(WebhookListenerTest, TakesReports) {
  start();
  EXPECT_THAT(listener->address(), HasSubstr("http://127.0.0.1:"));
  EXPECT_EQ(send(post("/known", "hello")), 204);
  EXPECT_EQ(send(post("/other", "")), 404);
  EXPECT_THAT(all_taken(), ElementsAre("/known hello", "/other "));
}

TEST_F(WebhookListenerTest, TellsWhatThrowsAndGoesOn) {
  start();
  Client bad(listener->address());
  bad.send(post("/bad", ""));
  EXPECT_EQ(thrown.get_future().get(), "this is too much");
  EXPECT_EQ(send(post("/known", "")), 204);
}

TEST_F(WebhookListenerTest, AnswersAndCloses) {
  start();
  Client client(listener->address());
  client.send(post("/known", "a"));
  EXPECT_EQ(client.receive_all(),
            "HTTP/1.1 204 No Content\r\nConnection: close\r\n\r\n");
}

TEST_F(WebhookListenerTest, RefusesWhatIsNoReport) {
  options.token = "geheim";
  options.max_body = 10;
  start();
  EXPECT_EQ(send(post("/known", "a")), 401);
  EXPECT_EQ(send(post("/known", "a", "Authorization: Bearer geheim\r\n")), 204);
  EXPECT_EQ(send("GET /known?token=geheim HTTP/1.1\r\n\r\n"), 405);
  EXPECT_EQ(send("hello\r\n\r\n"), 400);
  EXPECT_EQ(send(post("/known", std::string(11, 'x'))), 413);
  EXPECT_EQ(send("POST / HTTP/1.1\r\nX: " + std::string(9'000, 'x')), 431);
  EXPECT_THAT(all_taken(), ElementsAre("/known a"));
}

// The whole body is still on its way when the answer is given.
TEST_F(WebhookListenerTest, ASenderOfMuchHearsTheAnswer) {
  options.max_body = 10;
  start();
  EXPECT_EQ(send(post("/known", std::string(2'000'000, 'x'))), 413);
}

TEST_F(WebhookListenerTest, WhoSaysNothingIsLetGo) {
  options.patience = Milliseconds(50);
  start();
  EXPECT_EQ(send(""), 0);
  EXPECT_EQ(send("POST /known HTTP/1.1\r\nContent-Length: 9\r\n\r\nhalf"), 0);
  EXPECT_THAT(all_taken(), IsEmpty());
  EXPECT_EQ(send(post("/known", "a")), 204);
}

TEST_F(WebhookListenerTest, FewConnectionsAreOpenAtATime) {
  options.connections = 2;
  start();
  auto first = std::make_unique<Client>(listener->address());
  Client second(listener->address());
  first->send("POST");
  second.send("POST");
  Client third(listener->address());
  third.send(post("/known", "third"));
  first.reset(); // makes room
  EXPECT_EQ(third.status(), 204);
}

TEST_F(WebhookListenerTest, FewReportsAreTakenInASecond) {
  options.per_second = 3;
  start();
  int refused = 0;
  for (int i = 0; i < 100 && refused == 0; ++i)
    refused = send(post("/known", "a")) == 429 ? 1 : 0;
  EXPECT_EQ(refused, 1);
}

TEST_F(WebhookListenerTest, ItsEndClosesConnections) {
  start();
  Client client(listener->address());
  client.send("POST /known");
  listener.reset();
  EXPECT_EQ(client.receive_all(), "");
}

TEST_F(WebhookListenerTest, ManySendAtOnce) {
  options.per_second = 10'000;
  start();
  std::vector<std::future<int>> all;
  for (int i = 0; i < 50; ++i)
    all.push_back(std::async(std::launch::async, [this, i] {
      return send(post("/known", std::to_string(i)));
    }));
  for (auto& one : all)
    EXPECT_EQ(one.get(), 204);
  EXPECT_EQ(all_taken().size(), 50u);
}

TEST_F(WebhookListenerTest, SaysWhyItDoesNotListen) {
  auto error = [&](const std::string& listen) {
    options.listen = listen;
    const auto started = WebhookListener::start(
        options, [](const auto&) { return 204; }, [](const auto&) {});
    return started ? "" : started.error().message;
  };
  for (const auto* wrong : {"", "8090", "127.0.0.1", "127.0.0.1:x",
                            "127.0.0.1:70000", "example.com:80", ":80"})
    EXPECT_THAT(error(wrong), HasSubstr("such as 127.0.0.1:8090")) << wrong;
  EXPECT_THAT(error("0.0.0.0:0"), HasSubstr("give a 'token'"));
  options.listen = "127.0.0.1:0";
  start();
  EXPECT_THAT(error(listener->address().substr(7)),
              HasSubstr("webhooks cannot be heard at"));
  options.token = "geheim";
  EXPECT_EQ(error("0.0.0.0:0"), "");
}

} // namespace
} // namespace parlour::adapters::http
