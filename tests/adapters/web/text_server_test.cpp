// Visitors that behave and misbehave, by real sockets.
#include <future>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/web/bounds.hpp"
#include "adapters/web/text_server.hpp"
#include "tests/adapters/web/fake_host.hpp"
#include "tests/support/tcp_client.hpp"

namespace parlour::adapters::web {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

// Reads line by line.
class LineClient : public parlour::test::Client {
public:
  using Client::Client;
  std::string line() {
    for (;;) {
      const auto end = held_.find('\n');
      if (end != std::string::npos) {
        auto found = held_.substr(0, end);
        held_.erase(0, end + 1);
        return found;
      }
      auto more = receive_some();
      if (more.empty())
        return "closed";
      held_ += more;
    }
  }

private:
  std::string held_;
};

constexpr const char* hello = "{\"type\": \"hello\"}\n";
constexpr const char* upgrade =
    "GET / HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\n"
    "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
    "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";

class TextServerTest : public testing::Test {
protected:
  TextServerTest() {
    options.first_bytes = Milliseconds(20);
    options.book.sessions = 2;
  }
  ~TextServerTest() override {
    server = nullptr;
    EXPECT_THAT(thrown, IsEmpty());
  }
  void start() {
    auto started =
        TextServer::start(options, host, [this](const std::string& what) {
          thrown.push_back(what);
        });
    ASSERT_TRUE(started) << started.error().message;
    server = std::move(*started);
    host.teller = server.get();
  }
  // Of a request for a WebSocket.
  std::string answer_to(const std::string& request) {
    parlour::test::Client client(server->address());
    client.send(request);
    return client.receive_some();
  }

  ServerOptions options;
  test::FakeHost<TextServer> host;
  std::vector<std::string> thrown;
  std::unique_ptr<TextServer> server;
};

TEST_F(TextServerTest, GreetsAPersonAndAnswers) {
  start();
  LineClient person(server->address());
  EXPECT_EQ(person.line(), "Hello.");
  person.send("one\ntwo\r\nend\n");
  EXPECT_EQ(person.line(), "echo: one");
  EXPECT_EQ(person.line(), "echo: two");
  EXPECT_EQ(person.line(), "echo: end");
  EXPECT_EQ(person.line(), "closed");
}

TEST_F(TextServerTest, AnswersWhoPipesAndSaysNoMore) {
  start();
  LineClient person(server->address());
  person.send("one\nwithout a line end");
  person.shut();
  EXPECT_EQ(person.line(), "Hello.");
  EXPECT_EQ(person.line(), "echo: one");
  EXPECT_EQ(person.line(), "echo: without a line end");
  EXPECT_EQ(person.line(), "closed");
}

TEST_F(TextServerTest, ManyLinesAtOnceAreAllAnswered) {
  start();
  LineClient person(server->address());
  EXPECT_EQ(person.line(), "Hello.");
  std::string lines;
  for (int i = 0; i < 500; ++i)
    lines += std::to_string(i) + "\n";
  person.send(lines);
  for (int i = 0; i < 500; ++i)
    EXPECT_EQ(person.line(), "echo: " + std::to_string(i));
}

TEST_F(TextServerTest, TalksWithAProgramByLines) {
  start();
  LineClient program(server->address());
  program.send(hello);
  EXPECT_THAT(program.line(), HasSubstr("\"welcome\""));
  EXPECT_THAT(program.line(), HasSubstr("Hello."));
  program.send("{\"type\": \"turn\", \"turn\": 1, \"say\": \"one\"}\n");
  EXPECT_THAT(program.line(), HasSubstr("echo: one"));
  EXPECT_EQ(program.line(), R"({"type": "done", "turn": 1})");
  program.send("nonsense\n{\"type\": \"end\"}\n");
  EXPECT_THAT(program.line(), HasSubstr("column 2"));
  EXPECT_EQ(program.line(), R"({"type": "end"})");
  EXPECT_EQ(program.line(), "closed");
}

TEST_F(TextServerTest, ASessionIsResumedByAnotherConnection) {
  start();
  std::string session;
  {
    LineClient program(server->address());
    program.send(hello);
    program.line();
    program.line();
    program.send("{\"type\": \"turn\", \"turn\": 1, \"say\": \"one\"}\n");
    EXPECT_THAT(program.line(), HasSubstr("echo: one"));
  }
  LineClient program(server->address());
  program.send("{\"type\": \"hello\", \"session\": \"session-1\", "
               "\"output\": 2}\n");
  EXPECT_THAT(program.line(), HasSubstr("\"turn\": 1, \"resumed\": true"));
  EXPECT_EQ(program.line(), R"({"type": "done", "turn": 1})");
  EXPECT_EQ(server->counts().book.resumed, 1);
}

TEST_F(TextServerTest, RefusesWhomThereIsNoRoomFor) {
  start();
  LineClient first(server->address());
  LineClient second(server->address());
  EXPECT_EQ(first.line(), "Hello.");
  EXPECT_EQ(second.line(), "Hello.");
  LineClient third(server->address());
  EXPECT_EQ(third.line(), "! all 2 places are taken; try again later");
  EXPECT_EQ(third.line(), "closed");
  first.send("end\n");
  first.receive_all();
  LineClient fourth(server->address());
  EXPECT_EQ(fourth.line(), "Hello.");
}

TEST_F(TextServerTest, NothingIsLeftOfWhoHasBeenThere) {
  start();
  for (int i = 0; i < 50; ++i) {
    LineClient person(server->address());
    person.send("end\n");
    person.receive_all();
  }
  LineClient last(server->address());
  EXPECT_EQ(last.line(), "Hello.");
  EXPECT_EQ(server->counts().connections, 1);
  EXPECT_EQ(server->counts().sessions, 1);
}

TEST_F(TextServerTest, ALineThatIsTooLongIsLeftOut) {
  start();
  LineClient person(server->address());
  EXPECT_EQ(person.line(), "Hello.");
  person.send(std::string(5 * max_message, 'x'));
  EXPECT_THAT(person.line(), HasSubstr("at most 8192 bytes"));
  person.send(std::string(max_message, 'x') + "\nshort\n");
  EXPECT_EQ(person.line(), "echo: short");
}

TEST_F(TextServerTest, ALineWithoutEndIsNotReadForEver) {
  start();
  LineClient person(server->address());
  EXPECT_EQ(person.line(), "Hello.");
  person.send(std::string(3 << 20, 'x'));
  EXPECT_THAT(person.line(), HasSubstr("at most 8192 bytes"));
  EXPECT_EQ(person.line(), "! a line without an end");
}

TEST_F(TextServerTest, AFloodEndsTheConnection) {
  start();
  LineClient program(server->address());
  program.send(hello);
  std::string pings;
  for (int i = 0; i < 10'000; ++i)
    pings += "{\"type\": \"ping\"}\n";
  program.send(pings);
  const auto all = program.receive_all();
  EXPECT_THAT(all, HasSubstr("too-fast"));
}

// It never reads what it is told.
TEST_F(TextServerTest, AReaderWhoDoesNotReadIsLetGo) {
  options.book.linger = Milliseconds(0);
  start();
  LineClient program(server->address());
  program.send(hello);
  program.line();
  for (int i = 0; server->counts().connections != 0; ++i) {
    ASSERT_LT(i, 10'000);
    server->said(1, "session-1", {0, 0, "answer", std::string(100'000, 'x')});
  }
}

TEST_F(TextServerTest, HalfALineIsNotWaitedForLong) {
  options.patience = Milliseconds(50);
  start();
  LineClient person(server->address());
  person.send("{\"type\":");
  EXPECT_THAT(person.line(), HasSubstr("no whole line has come"));
  EXPECT_EQ(person.line(), "closed");
}

TEST_F(TextServerTest, AnswersWhatIsNoRequestForAWebSocket) {
  start();
  EXPECT_THAT(answer_to("GET / HTTP/1.1\r\nHost: a\r\n\r\n"),
              testing::AllOf(StartsWith("HTTP/1.1 426"),
                             HasSubstr("This port speaks WebSocket")));
  EXPECT_EQ(answer_to("GET nonsense\r\n\r\n"), "");
  EXPECT_EQ(answer_to("GET / HTTP/1.1\r\nX: " + std::string(max_head, 'x')),
            "");
}

TEST_F(TextServerTest, APageOfElsewhereMayNotConnect) {
  options.origins = {"https://kiosk.example"};
  start();
  const std::string request = upgrade;
  EXPECT_THAT(answer_to(request + "\r\n"), StartsWith("HTTP/1.1 101"));
  EXPECT_THAT(answer_to(request + "Origin: http://localhost:3000\r\n\r\n"),
              StartsWith("HTTP/1.1 101"));
  EXPECT_THAT(answer_to(request + "Origin: https://kiosk.example\r\n\r\n"),
              StartsWith("HTTP/1.1 101"));
  EXPECT_THAT(
      answer_to(request + "Origin: https://evil.example\r\n\r\n"),
      testing::AllOf(StartsWith("HTTP/1.1 403"), HasSubstr("--origin")));
}

TEST_F(TextServerTest, WhoSaysNoHelloByWebSocketIsLetGo) {
  options.patience = Milliseconds(50);
  start();
  parlour::test::Client client(server->address());
  client.send(std::string(upgrade) + "\r\n");
  EXPECT_THAT(client.receive_all(), HasSubstr("no hello has come"));
}

// A dead visitor: nothing comes back when it is pinged.
TEST_F(TextServerTest, WhoDoesNotAnswerAPingIsLetGo) {
  options.idle = Milliseconds(50);
  start();
  parlour::test::Client client(server->address());
  client.send(std::string(upgrade) + "\r\n");
  EXPECT_THAT(client.receive_all(), StartsWith("HTTP/1.1 101"));
}

// A frame must be masked, and have no reserved bits.
TEST_F(TextServerTest, BadFramesEndTheConnection) {
  start();
  for (const auto& frame :
       {std::string("\x81\x02{}"), std::string("\xf1\x80zzzz"),
        std::string("\x81\xff\xff\xff\xff\xff\xff\xff\xff\xffzzzz"),
        std::string("\x81\x81\0\0\0\0\xff", 7)}) {
    parlour::test::Client client(server->address());
    client.send(std::string(upgrade) + "\r\n");
    EXPECT_THAT(client.receive_some(), StartsWith("HTTP/1.1 101"));
    client.send(frame);
    client.receive_all();
  }
  EXPECT_THAT(answer_to(std::string(upgrade) + "\r\n\x81\x80zzzz"),
              StartsWith("HTTP/1.1 400"));
  LineClient person(server->address());
  EXPECT_EQ(person.line(), "Hello.");
}

TEST_F(TextServerTest, SaysSoWhenItEnds) {
  start();
  LineClient person(server->address());
  EXPECT_EQ(person.line(), "Hello.");
  server->stop_accepting();
  server->counts(); // it has
  EXPECT_FALSE(parlour::test::Client(server->address()).is_connected());
  person.send("still there?\n");
  EXPECT_EQ(person.line(), "echo: still there?");
  server = nullptr;
  EXPECT_EQ(person.line(), "! the server ends");
}

TEST_F(TextServerTest, SaysWhyItCannotListen) {
  start();
  options.port = static_cast<std::uint16_t>(
      std::stoi(server->address().substr(server->address().rfind(':') + 1)));
  auto second = TextServer::start(options, host, {});
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error().message, HasSubstr("already in use"));
  options.address = "nowhere";
  EXPECT_FALSE(TextServer::start(options, host, {}));
}

} // namespace
} // namespace parlour::adapters::web
