// What behaves and misbehaves is at its users: webhook_listener_test.cpp and
// tests/adapters/web/page_server_test.cpp.
#include <future>

#include <gmock/gmock.h>

#include "adapters/http/server/request_server.hpp"
#include "tests/support/no_descriptors.hpp"
#include "tests/support/tcp_client.hpp"

namespace parlour::adapters::http {
namespace {

using test::Client;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class RequestServerTest : public testing::Test {
protected:
  void start() {
    auto started = RequestServer::start(
        options,
        {[](const ReceivedRequest& request) {
           if (request.path == "/bad")
             throw 7;
           return Reply{200, request.method, "text/plain"};
         },
         [](int status) {
           return Reply{status, "never", "text/plain"};
         }},
        [this](const std::string& what) { thrown.set_value(what); });
    ASSERT_TRUE(started) << started.error().message;
    server = std::move(*started);
  }
  std::string answer_to(const std::string& request) {
    Client client(server->address());
    client.send(request);
    return client.receive_all();
  }

  RequestServerOptions options;
  std::promise<std::string> thrown;
  std::unique_ptr<RequestServer> server;
};

TEST_F(RequestServerTest, AnswersAndRefuses) {
  start();
  EXPECT_THAT(server->address(), StartsWith("127.0.0.1:"));
  EXPECT_THAT(answer_to("GET / HTTP/1.1\r\n\r\n"), EndsWith("GET"));
  EXPECT_THAT(answer_to(test::post("/", "a body where none may be")),
              EndsWith("never"));
}

TEST_F(RequestServerTest, OutlivesWhateverIsThrown) {
  start();
  Client bad(server->address());
  bad.send("GET /bad HTTP/1.1\r\n\r\n");
  EXPECT_EQ(thrown.get_future().get(), "an exception of an unknown type");
  EXPECT_THAT(answer_to("GET / HTTP/1.1\r\n\r\n"), EndsWith("GET"));
}

TEST_F(RequestServerTest, MoreThanItServesWaitOrAreClosed) {
  options.connections = 1;
  start();
  {
    Client first(server->address());
    Client second(server->address());
    second.send("GET / HTTP/1.1\r\n\r\n");
    first.send("GET / HTTP/1.1\r\n\r\n");
    EXPECT_THAT(first.receive_all(), EndsWith("GET"));
    first.close();
    EXPECT_THAT(second.receive_all(), EndsWith("GET"));
  }
  server.reset();
  options.closes_more = true;
  start();
  Client first(server->address());
  EXPECT_EQ(Client(server->address()).receive_all(), "");
}

TEST_F(RequestServerTest, SaysWhyItCannotListen) {
  start();
  const auto refusal = [&] {
    const auto second = RequestServer::start(options, {}, {});
    return second ? "" : second.error().message;
  };
  options.port = static_cast<std::uint16_t>(
      std::stoi(server->address().substr(server->address().rfind(':') + 1)));
  EXPECT_EQ(refusal(), "Address already in use");
  options.address = "nowhere";
  EXPECT_EQ(refusal(), "'nowhere' is no address of this machine");
  const test::NoDescriptors none;
  EXPECT_EQ(refusal(), "Too many open files");
}

} // namespace
} // namespace parlour::adapters::http
