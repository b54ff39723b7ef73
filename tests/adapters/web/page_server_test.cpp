// Who asks for pages as it should be done, and who does not.
#include <future>
#include <stdexcept>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/web/bounds.hpp"
#include "adapters/web/page_server.hpp"
#include "tests/support/tcp_client.hpp"

namespace parlour::adapters::web {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class PageServerTest : public testing::Test {
protected:
  PageServerTest() {
    options.pages["/metrics"] = [] {
      return Page{true, "turns 3\n", "text/special"};
    };
    options.pages["/health"] = [this] { return Page{is_well, "so so\n"}; };
    options.pages["/broken"] = []() -> Page {
      throw std::runtime_error("no numbers");
    };
  }
  void start() {
    auto started = PageServer::start(
        options, [this](const std::string& what) { thrown.push_back(what); });
    ASSERT_TRUE(started) << started.error().message;
    server = std::move(*started);
  }
  std::string answer_to(const std::string& request) {
    parlour::test::Client client(server->address());
    client.send(request);
    return client.receive_all();
  }
  std::string get(const std::string& target, const char* method = "GET") {
    return answer_to(std::string(method) + " " + target +
                     " HTTP/1.1\r\nHost: x\r\n\r\n");
  }

  std::atomic<bool> is_well = true;
  PageServerOptions options;
  std::vector<std::string> thrown; // looked at when the server has ended
  std::unique_ptr<PageServer> server;
};

TEST_F(PageServerTest, TellsAPage) {
  start();
  const auto answer = get("/metrics");
  EXPECT_THAT(answer, AllOf(StartsWith("HTTP/1.1 200 OK\r\n"),
                            HasSubstr("Content-Type: text/special\r\n"),
                            HasSubstr("Content-Length: 8\r\n"),
                            HasSubstr("Connection: close\r\n"),
                            EndsWith("\r\n\r\nturns 3\n")));
  EXPECT_THAT(get("/metrics?name=x"), EndsWith("turns 3\n"));
  EXPECT_THAT(get("/metrics", "HEAD"),
              AllOf(HasSubstr("Content-Length: 8\r\n"), EndsWith("\r\n\r\n")));
}

TEST_F(PageServerTest, WhatIsNotWellHasAStatusThatSaysSo) {
  start();
  EXPECT_THAT(get("/health"), StartsWith("HTTP/1.1 200 "));
  is_well = false;
  EXPECT_THAT(get("/health"),
              AllOf(StartsWith("HTTP/1.1 503 "), EndsWith("so so\n")));
  EXPECT_THAT(get("/broken"),
              AllOf(StartsWith("HTTP/1.1 500 "), EndsWith("no numbers\n")));
}

// Its visitor is left without an answer; the others are served.
TEST_F(PageServerTest, OutlivesWhateverIsThrown) {
  std::promise<void> begins;
  options.pages["/mad"] = [&]() -> Page {
    begins.set_value();
    throw 42;
  };
  start();
  parlour::test::Client mad(server->address());
  mad.send("GET /mad HTTP/1.1\r\n\r\n");
  begins.get_future().wait();
  EXPECT_THAT(get("/health"), StartsWith("HTTP/1.1 200 "));
  server.reset();
  EXPECT_THAT(thrown, testing::ElementsAre("an exception of an unknown type"));
}

TEST_F(PageServerTest, RefusesWhatIsNoRequestForAPage) {
  start();
  EXPECT_THAT(get("/"), AllOf(StartsWith("HTTP/1.1 404 "),
                              HasSubstr("/health, /metrics")));
  EXPECT_THAT(get("/metrics", "POST"), AllOf(StartsWith("HTTP/1.1 405 "),
                                             HasSubstr("Allow: GET, HEAD")));
  EXPECT_THAT(get("/metrics", "NONSENSE"), StartsWith("HTTP/1.1 405 "));
  EXPECT_THAT(answer_to("nonsense\r\n\r\n"), StartsWith("HTTP/1.1 400 "));
  EXPECT_THAT(answer_to("GET /metrics HTTP/9.9\r\n\r\n"),
              StartsWith("HTTP/1.1 400 "));
  EXPECT_THAT(answer_to("GET /metrics HTTP/1.1\r\nContent-Length: 7\r\n\r\n"),
              StartsWith("HTTP/1.1 413 "));
  const std::string much(max_head, 'x');
  EXPECT_THAT(answer_to("GET /metrics HTTP/1.1\r\nX: " + much + "\r\n\r\n"),
              StartsWith("HTTP/1.1 431 "));
  EXPECT_THAT(get("/metrics"), EndsWith("turns 3\n"));
}

// It is closed when its time is over, without an answer.
TEST_F(PageServerTest, DoesNotWaitForeverForARequest) {
  options.patience = Milliseconds(20);
  start();
  parlour::test::Client silent(server->address());
  parlour::test::Client slow(server->address());
  slow.send("GET /metrics HT");
  EXPECT_EQ(silent.receive_all(), "");
  EXPECT_EQ(slow.receive_all(), "");
}

TEST_F(PageServerTest, ServesSoManyAtATimeAndClosesMore) {
  options.connections = 2;
  start();
  {
    parlour::test::Client first(server->address());
    parlour::test::Client second(server->address());
    parlour::test::Client third(server->address());
    EXPECT_EQ(third.receive_all(), "");
    first.send("GET /metrics HTTP/1.1\r\n\r\n");
    second.send("GET /metrics HTTP/1.1\r\n\r\n");
    EXPECT_THAT(first.receive_all(), EndsWith("turns 3\n"));
    EXPECT_THAT(second.receive_all(), EndsWith("turns 3\n"));
  }
  // The places are free again, once the server has seen it.
  while (get("/metrics").empty())
    std::this_thread::yield();
}

TEST_F(PageServerTest, SomebodyWhoDoesNotReadEndsWithTheServer) {
  options.pages["/much"] = [] {
    return Page{true, std::string(50 << 20, 'x')};
  };
  start();
  parlour::test::Client lazy(server->address());
  lazy.send("GET /much HTTP/1.1\r\n\r\n");
  lazy.receive_some();
  server = nullptr;
  lazy.receive_all();
}

TEST_F(PageServerTest, SaysWhyItCannotListen) {
  start();
  PageServerOptions same;
  same.port = static_cast<std::uint16_t>(
      std::stoi(server->address().substr(server->address().rfind(':') + 1)));
  const auto second = PageServer::start(same, {});
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("in use"));
  PageServerOptions nowhere;
  nowhere.address = "nowhere";
  EXPECT_FALSE(PageServer::start(nowhere, {}));
}

} // namespace
} // namespace parlour::adapters::web
