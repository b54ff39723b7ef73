#include <future>

#include <gmock/gmock.h>

#include "adapters/http/transfer/http_client.hpp"
#include "tests/adapters/http/service_server.hpp"

namespace parlour::adapters::http {
namespace {

using Kind = HttpFailure::Kind;
using Then = test::Reply::Then;
using test::reply;
using test::ServiceServer;
using testing::HasSubstr;
using testing::Not;

class HttpClientTest : public testing::Test {
protected:
  HttpClientTest() {
    options.exchange.retry.pause = Milliseconds(1);
    options.timeout = Milliseconds(20'000);
  }

  std::future<TryOutcome> submit(HttpRequest request) {
    if (!client)
      client = std::move(*HttpClient::start(
          options, [this](const auto& what) { thrown.set_value(what); }));
    auto promise = std::make_shared<std::promise<TryOutcome>>();
    auto future = promise->get_future();
    client->submit(std::move(request), [promise](TryOutcome outcome) {
      promise->set_value(std::move(outcome));
    });
    return future;
  }
  std::future<TryOutcome> submit_get(const ServiceServer& server,
                                     const std::string& target = "/") {
    return submit({Method::get, server.address() + target});
  }
  TryOutcome get(const ServiceServer& server, const std::string& target = "/") {
    return submit_get(server, target).get();
  }

  ClientOptions options;
  std::promise<std::string> thrown;
  std::unique_ptr<HttpClient> client;
};

test::Reply silence() {
  return {"", Then::nothing};
}

TEST_F(HttpClientTest, TriesAgainUntilTheServiceAnswers) {
  ServiceServer server([](auto&, int number) {
    return number == 1   ? reply(500)
           : number == 2 ? test::Reply{"", Then::close}
                         : reply(200, "at last");
  });
  const auto outcome = get(server);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->body, "at last");
  EXPECT_EQ(server.requests().size(), 3u);
}

TEST_F(HttpClientTest, GivesUpAfterItsRetries) {
  ServiceServer server([](auto&, int) { return reply(503, "no"); });
  EXPECT_EQ(get(server)->status, 503);
  EXPECT_EQ(server.requests().size(), 3u);
}

TEST_F(HttpClientTest, APostIsSentOnce) {
  ServiceServer server([](auto&, int) { return reply(503); });
  const HttpRequest post{Method::post, server.address() + "/", {}, "x", false};
  EXPECT_EQ(submit(post).get()->status, 503);
  EXPECT_EQ(server.requests().size(), 1u);
}

TEST_F(HttpClientTest, FollowsRedirectsWithoutSecretsToOthers) {
  ServiceServer other([](auto&, int) { return reply(200, "there"); });
  ServiceServer server([&](auto& request, int) {
    return request.find("/a ") != std::string::npos
               ? reply(302, "", "Location: /b\r\n")
               : reply(302, "", "Location: " + other.address() + "/c\r\n");
  });
  const auto outcome = submit({Method::get,
                               server.address() + "/a",
                               {{"X-Key", "geheim", true}, {"X-Open", "1"}}})
                           .get();
  ASSERT_TRUE(outcome) << outcome.error().reason;
  EXPECT_EQ(outcome->body, "there");
  EXPECT_THAT(server.requests().at(1), HasSubstr("X-Key: geheim"));
  EXPECT_THAT(other.requests().at(0), HasSubstr("X-Open: 1"));
  EXPECT_THAT(other.requests().at(0), Not(HasSubstr("geheim")));
}

TEST_F(HttpClientTest, RunsInNoCircle) {
  ServiceServer server(
      [](auto&, int) { return reply(302, "", "Location: /\r\n"); });
  EXPECT_THAT(get(server).error().reason, HasSubstr("more than 3 times"));
  EXPECT_EQ(server.requests().size(), 4u);
}

TEST_F(HttpClientTest, TheTimeIsForAllTries) {
  options.timeout = Milliseconds(150);
  options.exchange.retry.retries = 10;
  ServiceServer server([](auto&, int) { return silence(); });
  EXPECT_EQ(get(server).error().kind, Kind::late);
  EXPECT_EQ(server.requests().size(), 1u);
}

TEST_F(HttpClientTest, ARequestMayHaveATimeOfItsOwn) {
  ServiceServer server([](auto&, int) { return silence(); });
  HttpRequest request{Method::get, server.address() + "/"};
  request.timeout = Milliseconds(50);
  EXPECT_EQ(submit(request).get().error().kind, Kind::late);
}

TEST_F(HttpClientTest, AServiceThatFailsIsLeftAlone) {
  options.exchange.retry.retries = 0;
  options.breaker.failures = 2;
  ServiceServer server([](auto&, int) { return reply(503); });
  EXPECT_TRUE(get(server));
  EXPECT_TRUE(get(server));
  const auto refused = get(server);
  EXPECT_EQ(refused.error().kind, Kind::refused);
  EXPECT_THAT(refused.error().reason,
              HasSubstr("has failed 2 times in a row (it answered 503)"));
  EXPECT_FALSE(refused.error().was_sent);
  EXPECT_EQ(server.requests().size(), 2u);
}

TEST_F(HttpClientTest, IsAskedAgainAfterThePause) {
  options.exchange.retry.retries = 0;
  options.breaker = {1, Milliseconds(1)};
  ServiceServer server([](auto&, int number) {
    return number == 1 ? reply(500) : reply(200, "well");
  });
  EXPECT_EQ(get(server)->status, 500);
  TryOutcome outcome = tl::make_unexpected(HttpFailure());
  while (!outcome) // until the pause is over
    outcome = get(server);
  EXPECT_EQ(outcome->body, "well");
}

TEST_F(HttpClientTest, OtherServicesAreNotLeftAlone) {
  options.exchange.retry.retries = 0;
  options.breaker.failures = 1;
  ServiceServer bad([](auto&, int) { return reply(500); });
  ServiceServer good([](auto&, int) { return reply(200); });
  EXPECT_TRUE(get(bad));
  EXPECT_FALSE(get(bad));
  EXPECT_TRUE(get(good));
}

TEST_F(HttpClientTest, SomeRunAndTheOthersWait) {
  options.connections = 2;
  ServiceServer server([](auto&, int) { return reply(200); });
  std::vector<std::future<TryOutcome>> all;
  for (int i = 0; i < 40; ++i)
    all.push_back(submit_get(server));
  for (auto& one : all)
    EXPECT_TRUE(one.get());
}

TEST_F(HttpClientTest, TheQueueHasAnEnd) {
  options.connections = 1;
  options.queue = 1;
  ServiceServer server([](auto&, int) { return silence(); });
  auto running = submit_get(server);
  auto waiting = submit_get(server);
  EXPECT_THAT(submit_get(server).get().error().reason,
              HasSubstr("as 2 requests wait already"));
  client.reset();
  EXPECT_TRUE(running.get().error().was_sent);
  EXPECT_FALSE(waiting.get().error().was_sent);
}

TEST_F(HttpClientTest, WhoeverWaitsTooLongIsNotSent) {
  options.connections = 1;
  ServiceServer server([](auto&, int) { return silence(); });
  auto running = submit_get(server);
  HttpRequest request{Method::get, server.address() + "/waits"};
  request.timeout = Milliseconds(50);
  const auto outcome = submit(request).get();
  EXPECT_THAT(outcome.error().reason, HasSubstr("was not asked in time"));
  EXPECT_FALSE(outcome.error().was_sent);
  client.reset();
  EXPECT_FALSE(running.get());
}

TEST_F(HttpClientTest, ItsEndAnswersAll) {
  options.exchange.retry.pause = Milliseconds(10'000);
  ServiceServer server([](auto& request, int) {
    return request.find("/pause") != std::string::npos ? reply(500) : silence();
  });
  auto pausing = submit_get(server, "/pause");
  auto running = submit_get(server);
  server.wait_for(2);
  client.reset();
  EXPECT_THAT(running.get().error().reason, HasSubstr("the component ends"));
  EXPECT_FALSE(pausing.get());
}

TEST_F(HttpClientTest, TellsWhatThrowsAndGoesOn) {
  ServiceServer server([](auto&, int) { return reply(200, "here"); });
  EXPECT_TRUE(get(server));
  client->submit({Method::get, server.address() + "/"}, [](const auto&) {
    throw std::runtime_error("this is too much");
  });
  EXPECT_EQ(thrown.get_future().get(), "this is too much");
  EXPECT_TRUE(get(server));
}

TEST_F(HttpClientTest, SaysIfItCannotBegin) {
  const auto started = HttpClient::start(
      options, [](const auto&) {},
      [](Loop&, TransferOptions) -> Expected<std::unique_ptr<Transfers>> {
        return fail(ErrorKind::settings, "there is no library");
      });
  EXPECT_EQ(started.error().message, "there is no library");
}

} // namespace
} // namespace parlour::adapters::http
