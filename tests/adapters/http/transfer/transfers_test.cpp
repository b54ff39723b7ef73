// Each way in which a server behaves and misbehaves.
#include <future>

#include <gmock/gmock.h>

#include "adapters/http/transfer/transfers.hpp"
#include "tests/adapters/http/service_server.hpp"
#include "tests/support/start_loop.hpp"

namespace parlour::adapters::http {
namespace {

using Kind = HttpFailure::Kind;
using Then = test::Reply::Then;
using test::reply;
using test::ServiceServer;
using testing::HasSubstr;
using testing::Not;

class TransfersTest : public testing::Test {
protected:
  ~TransfersTest() override {
    on_loop([this] { transfers_.reset(); });
    loop_->stop();
  }

  // Runs the action on the loop's thread and waits for it.
  void on_loop(const std::function<void()>& action) {
    std::promise<void> done;
    loop_->post([&] {
      action();
      done.set_value();
    });
    done.get_future().wait();
  }
  std::future<TryOutcome> start(const HttpRequest& request,
                                Milliseconds time = Milliseconds(20'000)) {
    auto promise = std::make_shared<std::promise<TryOutcome>>();
    auto future = promise->get_future();
    on_loop([&] {
      if (!transfers_)
        transfers_ = curl_transfers(*loop_, options).value();
      id = transfers_->start(request, time, [promise](TryOutcome outcome) {
        promise->set_value(std::move(outcome));
      });
    });
    return future;
  }
  TryOutcome get(const ServiceServer& server, const std::string& target = "/",
                 Milliseconds time = Milliseconds(20'000)) {
    return start({Method::get, server.address() + target}, time).get();
  }
  // The failure of a GET that gets these bytes.
  HttpFailure failure(const std::string& bytes, Then then,
                      Milliseconds time = Milliseconds(20'000)) {
    ServiceServer server([&](auto&, int) { return test::Reply{bytes, then}; });
    const auto outcome = get(server, "/", time);
    if (outcome)
      ADD_FAILURE() << outcome->status << ' ' << outcome->body;
    return outcome ? HttpFailure() : outcome.error();
  }

  void cancel() {
    transfers_->cancel(id);
  }

  TransferOptions options;
  Transfers::Id id = 0;

private:
  const std::unique_ptr<Loop> loop_ = test::start_loop();
  std::unique_ptr<Transfers> transfers_;
};

TEST_F(TransfersTest, SendsAGet) {
  ServiceServer server([](auto&, int) { return reply(200, "hello"); });
  const auto outcome =
      start({Method::get, server.address() + "/a?b=c%20d", {{"X-A", "1"}}})
          .get();
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->status, 200);
  EXPECT_EQ(outcome->body, "hello");
  const auto request = server.requests().at(0);
  EXPECT_THAT(request, testing::StartsWith("GET /a?b=c%20d HTTP/1.1\r\n"));
  EXPECT_THAT(request, HasSubstr("\r\nX-A: 1\r\n"));
  EXPECT_THAT(request, HasSubstr("\r\nUser-Agent: Parlour\r\n"));
}

TEST_F(TransfersTest, SendsBodiesByEachMethod) {
  ServiceServer server([](auto&, int) { return reply(204); });
  for (const auto method : {Method::post, Method::put, Method::patch}) {
    const auto outcome = start({method,
                                server.address() + "/",
                                {{"Content-Type", "text/plain"}, {"Empty", ""}},
                                "a body"})
                             .get();
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->status, 204);
    const auto request = server.requests().back();
    EXPECT_THAT(request, testing::StartsWith(std::string(name_of(method))));
    EXPECT_THAT(request, testing::EndsWith("\r\n\r\na body"));
    EXPECT_THAT(request, HasSubstr("\r\nContent-Type: text/plain\r\n"));
    EXPECT_THAT(request, HasSubstr("\r\nEmpty:\r\n"));
    EXPECT_THAT(request, Not(HasSubstr("Expect")));
  }
  ASSERT_TRUE(start({Method::remove, server.address() + "/x"}).get());
  EXPECT_THAT(server.requests().back(), testing::StartsWith("DELETE /x "));
  ASSERT_TRUE(start({Method::post, server.address() + "/"}).get());
  EXPECT_THAT(server.requests().back(), HasSubstr("Content-Length: 0"));
  EXPECT_THAT(server.requests().back(), Not(HasSubstr("Content-Type")));
}

TEST_F(TransfersTest, TellsWhatTheServiceAsksFor) {
  ServiceServer server(
      [](auto&, int) { return reply(503, "", "Retry-After: 7\r\n"); });
  const auto outcome = get(server);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->retry_after, Milliseconds(7'000));
}

TEST_F(TransfersTest, ARedirectIsAnAnswer) {
  ServiceServer server(
      [](auto&, int) { return reply(302, "", "Location: ../b?c\r\n"); });
  const auto outcome = get(server, "/x/a");
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->redirect, server.address() + "/b?c");
  EXPECT_EQ(server.requests().size(), 1u);
}

TEST_F(TransfersTest, NobodyListens) {
  std::string address;
  {
    ServiceServer server([](auto&, int) { return reply(200); });
    address = server.address();
  }
  const auto outcome = start({Method::get, address + "/"}).get();
  EXPECT_EQ(outcome.error().kind, Kind::unreachable);
  EXPECT_FALSE(outcome.error().was_sent);
}

TEST_F(TransfersTest, TheServerNeverAnswers) {
  const auto late = failure("", Then::nothing, Milliseconds(100));
  EXPECT_EQ(late.kind, Kind::late);
  EXPECT_TRUE(late.was_sent);
  EXPECT_EQ(failure("HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\nhalf",
                    Then::nothing, Milliseconds(100))
                .kind,
            Kind::late);
}

TEST_F(TransfersTest, TheServerClosesAtOnce) {
  const auto broken = failure("", Then::close);
  EXPECT_EQ(broken.kind, Kind::broken_off);
  EXPECT_TRUE(broken.was_sent);
}

TEST_F(TransfersTest, TheAnswerIsCutInTheMiddle) {
  for (const auto* bytes :
       {"HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\nhalf",
        "HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n\r\n9\r\nhalf",
        "HTTP/1.1 200 OK\r\nContent-Le"})
    EXPECT_EQ(failure(bytes, Then::close).kind, Kind::broken_off) << bytes;
}

TEST_F(TransfersTest, TheAnswerIsNoHttp) {
  EXPECT_EQ(failure("220 mail.example.com ESMTP\r\n", Then::close).kind,
            Kind::not_http);
}

TEST_F(TransfersTest, TheAnswerIsHuge) {
  options.max_answer = 1'000;
  EXPECT_EQ(failure("HTTP/1.1 200 OK\r\nContent-Length: 9999999999\r\n\r\n",
                    Then::nothing)
                .kind,
            Kind::too_large);
  // Nobody has said before how long it is.
  EXPECT_EQ(failure("HTTP/1.1 200 OK\r\n\r\n" + std::string(2'000, 'x'),
                    Then::nothing)
                .kind,
            Kind::too_large);
  EXPECT_EQ(failure(
                "HTTP/1.1 200 OK\r\n" +
                    [] {
                      std::string lines;
                      for (int i = 0; i < 2'000; ++i)
                        lines += "X-" + std::to_string(i) + ": " +
                                 std::string(60, 'y') + "\r\n";
                      return lines;
                    }(),
                Then::nothing)
                .kind,
            Kind::too_large);
}

TEST_F(TransfersTest, AnAnswerOfExactlyTheLimitIsTaken) {
  options.max_answer = 1'000;
  ServiceServer server(
      [](auto&, int) { return reply(200, std::string(1'000, 'x')); });
  const auto outcome = get(server);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->body.size(), 1'000u);
}

// libcurl would send it again by itself.
TEST_F(TransfersTest, APostIsNeverSentTwice) {
  ServiceServer server([](auto&, int number) {
    return number == 1 ? reply(200) : test::Reply{"", Then::close};
  });
  const HttpRequest post{Method::post, server.address() + "/", {}, "x", false};
  EXPECT_TRUE(start(post).get());
  const auto broken = start(post).get();
  EXPECT_EQ(broken.error().kind, Kind::broken_off);
  EXPECT_EQ(server.requests().size(), 2u);
}

TEST_F(TransfersTest, ManyRunAtOnce) {
  ServiceServer server([](auto& request, int) {
    return reply(200, request.substr(5, request.find(' ', 5) - 5));
  });
  std::vector<std::future<TryOutcome>> all;
  for (int i = 0; i < 50; ++i)
    all.push_back(
        start({Method::get, server.address() + "/" + std::to_string(i)}));
  for (int i = 0; i < 50; ++i)
    EXPECT_EQ(all[static_cast<std::size_t>(i)].get()->body, std::to_string(i));
}

TEST_F(TransfersTest, WhatIsCancelledSaysNothing) {
  ServiceServer server([](auto&, int) {
    return test::Reply{"", Then::nothing};
  });
  auto outcome = start({Method::get, server.address() + "/"});
  server.wait_for(1);
  on_loop([this] {
    cancel();
    cancel(); // once more does nothing
  });
  EXPECT_THROW(outcome.get(), std::future_error); // nobody holds the promise
}

TEST_F(TransfersTest, OtherProtocolsAreRefused) {
  EXPECT_FALSE(start({Method::get, "file:///etc/passwd"}).get());
}

// No error may show a part of the address: it can hold a secret.
TEST_F(TransfersTest, NoReasonHasAnAddress) {
  ServiceServer server([](auto&, int) { return test::Reply{"", Then::close}; });
  EXPECT_THAT(get(server, "/?key=geheim").error().reason,
              Not(HasSubstr("geheim")));
  EXPECT_THAT(start({Method::get, "http://nowhere.invalid/?key=geheim"})
                  .get()
                  .error()
                  .reason,
              Not(HasSubstr("geheim")));
}

} // namespace
} // namespace parlour::adapters::http
