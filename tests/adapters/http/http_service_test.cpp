// The whole plug-in against servers of the test's own.
#include <gmock/gmock.h>

#include "adapters/http/http_service.hpp"
#include "runtime/plugin/conformance.hpp"
#include "runtime/plugin/test_host.hpp"
#include "runtime/text/json_text.hpp"
#include "tests/adapters/http/service_server.hpp"
#include "tests/support/tcp_client.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters::http {
namespace {

using Then = test::Reply::Then;
using test::reply;
using test::ServiceServer;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr auto rules = R"(<service role="SMS">
  <command name="Send">
    <post url="/messages">
      <header name="Authorization" value="Bearer ${KEY}"/>
      <body type="json">{"to": "{number}", "text": "{text}"}</body>
    </post>
    <on has="/error">
      <event name="Failed"><param value="{/error}"/></event>
    </on>
    <on><event name="Sent"/></on>
    <sample>{"id": 1}</sample>
    <sample for="0">{"error": "no number"}</sample>
  </command>
  <command name="Balance">
    <get url="/balance?key=${KEY}"/>
    <on><event name="Balance"><param value="{/left}"/></event></on>
  </command>
</service>)";

class HTTPServiceTest : public testing::Test {
protected:
  HTTPServiceTest() {
    folder.write("sms.xml", rules);
    host.application = folder.path().string();
    options["rules"] = "sms.xml";
    options["retries"] = "0";
  }
  ~HTTPServiceTest() override {
    service.stop();
  }

  Expected<void> start(const std::string& address) {
    options["address"] = address;
    return service.start(host, options);
  }
  void send(const std::string& command, std::vector<Value> params) {
    Message message;
    message.command = command;
    message.params = std::move(params);
    message.session = "one";
    message.correlation = ++correlation;
    service.receive(message);
  }
  // The events of one command, with their parameters.
  std::vector<std::string> ask(const std::string& command,
                               std::vector<Value> params) {
    send(command, std::move(params));
    std::vector<std::string> texts;
    host.wait(
        [&] {
          for (const auto& event : host.take_events()) {
            EXPECT_EQ(event.session, "one");
            EXPECT_EQ(event.correlation, correlation);
            texts.push_back(event.command + json_text(Value(event.params)));
          }
          return !texts.empty();
        },
        Milliseconds(20'000));
    return texts;
  }

  test::TemporaryFolder folder;
  TestHost host;
  Options options;
  HTTPService service{[](const std::string& name) -> std::string {
    return name == "KEY" ? "geheim" : "";
  }};
  Correlation correlation = 0;
};

TEST_F(HTTPServiceTest, SendsACommandAndTellsTheAnswer) {
  ServiceServer server([](auto&, int) { return reply(201, "{}"); });
  ASSERT_TRUE(start(server.address()));
  EXPECT_THAT(ask("Send", {"+49 1", "your \"taxi\""}), ElementsAre("Sent[]"));
  const auto request = server.requests().at(0);
  EXPECT_THAT(request, HasSubstr("POST /messages HTTP/1.1\r\n"));
  EXPECT_THAT(request, HasSubstr("Authorization: Bearer geheim\r\n"));
  EXPECT_THAT(request,
              HasSubstr(R"({"to": "+49 1", "text": "your \"taxi\""})"));
}

// As a host in another process does where the event is too long.
struct RefusingHost : TestHost {
  void fire_event(Message) override {
    throw std::runtime_error("17 MiB are too many");
  }
};

TEST_F(HTTPServiceTest, HasFailedWhereItsAnswerIsRefused) {
  ServiceServer server([](auto&, int) { return reply(201, "{}"); });
  RefusingHost refusing;
  refusing.application = host.application;
  options["address"] = server.address();
  ASSERT_TRUE(service.start(refusing, options));
  send("Send", {"1", "a"});
  std::vector<std::string> failures;
  EXPECT_TRUE(refusing.wait(
      [&] { return !(failures = refusing.take_failures()).empty(); },
      Milliseconds(20'000)));
  EXPECT_THAT(failures, ElementsAre("17 MiB are too many"));
  service.stop();
}

TEST_F(HTTPServiceTest, TellsWhatTheServiceSays) {
  ServiceServer server([](auto&, int number) {
    return number == 1   ? reply(200, R"({"error":"no such number"})")
           : number == 2 ? reply(401, "{}")
           : number == 3 ? reply(200, R"({"left":7})")
                         : reply(200, "<html>");
  });
  ASSERT_TRUE(start(server.address()));
  const auto name = server.address().substr(7);
  EXPECT_THAT(ask("Send", {"1", "a"}),
              ElementsAre(R"(Failed["no such number"])"));
  EXPECT_THAT(ask("Send", {"1", "a"}),
              ElementsAre("Failed[\"" + name + " answered 401.\"]"));
  EXPECT_THAT(ask("Balance", {}), ElementsAre("Balance[7]"));
  EXPECT_THAT(ask("Balance", {}), ElementsAre(HasSubstr("is no JSON")));
}

TEST_F(HTTPServiceTest, RefusesWhatItCannotSend) {
  ServiceServer server([](auto&, int) { return reply(200); });
  ASSERT_TRUE(start(server.address()));
  EXPECT_THAT(ask("Send", {"1"}),
              ElementsAre(R"(Failed["Send needs 'text'."])"));
  EXPECT_THAT(ask("Cancel", {}),
              ElementsAre(R"(Failed["The service has no command 'Cancel'."])"));
  EXPECT_THAT(server.requests(), IsEmpty());
}

// Whether the message has gone out is what a script must know.
TEST_F(HTTPServiceTest, SaysIfAMessageIsInDoubt) {
  ServiceServer server([](auto&, int) { return test::Reply{"", Then::close}; });
  ASSERT_TRUE(start(server.address()));
  EXPECT_THAT(ask("Send", {"1", "a"}),
              ElementsAre(HasSubstr("broke off the connection; whether it has "
                                    "carried out the request is not known.")));
  EXPECT_THAT(ask("Balance", {}), ElementsAre(Not(HasSubstr("whether"))));
}

TEST_F(HTTPServiceTest, NoAnswerHasASecret) {
  ServiceServer server([](auto&, int number) {
    return number == 1   ? test::Reply{"", Then::close}
           : number == 2 ? reply(500)
           : number == 3 ? reply(302, "", "Location: ftp://geheim@x/\r\n")
                         : reply(200, "geheim");
  });
  ASSERT_TRUE(start(server.address()));
  for (int i = 0; i < 4; ++i)
    EXPECT_THAT(
        ask("Balance", {}),
        ElementsAre(AllOf(HasSubstr("Failed"), Not(HasSubstr("geheim")))));
  for (const auto& line : host.take_logs())
    EXPECT_THAT(line, Not(HasSubstr("geheim")));
}

TEST_F(HTTPServiceTest, SamplesAskNobody) {
  options["samples"] = "true";
  ASSERT_TRUE(start("http://nowhere.invalid"));
  EXPECT_THAT(ask("Send", {"1", "a"}), ElementsAre("Sent[]"));
  EXPECT_THAT(ask("Send", {"0", "a"}), ElementsAre(R"(Failed["no number"])"));
  EXPECT_THAT(ask("Balance", {}), ElementsAre(HasSubstr("no <sample>")));
}

TEST_F(HTTPServiceTest, AnswersOneByOneIfTold) {
  options["one-by-one"] = "true";
  ServiceServer server([](auto&, int) { return reply(200, R"({"left":1})"); });
  ASSERT_TRUE(start(server.address()));
  send("Balance", {});
  EXPECT_EQ(host.take_events().size(), 1u); // without waiting
}

TEST_F(HTTPServiceTest, ItsEndAnswersAll) {
  ServiceServer server([](auto&, int) {
    return test::Reply{"", Then::nothing};
  });
  ASSERT_TRUE(start(server.address()));
  send("Balance", {});
  send("Send", {"1", "a"});
  server.wait_for(2);
  service.stop();
  EXPECT_EQ(host.take_events().size(), 2u);
  EXPECT_THAT(ask("Balance", {}), ElementsAre(HasSubstr("has ended")));
}

constexpr auto reports = R"(<service role="SMS">
  <webhook path="/inbox">
    <on has="/From">
      <event name="Received"><param value="{/From}"/><param value="{/Body}"/></event>
    </on>
  </webhook>
</service>)";

class WebhooksTest : public HTTPServiceTest {
protected:
  WebhooksTest() {
    folder.write("sms.xml", reports);
    options["listen"] = "127.0.0.1:0";
    options["token"] = "streng";
  }
  // The status that a report is answered with.
  int report(const std::string& target, const std::string& body,
             const std::string& headers = "") {
    if (address.empty())
      address = host.take_logs().at(0);
    test::Client client(address);
    client.send(test::post(target, body, headers));
    return client.status();
  }
  std::string address;
};

TEST_F(WebhooksTest, BecomeEventsThatAnswerNobody) {
  ASSERT_TRUE(start("http://a.com"));
  EXPECT_EQ(report("/inbox?token=streng", R"({"From":"+49 1","Body":"late"})"),
            204);
  EXPECT_EQ(report("/inbox?token=streng", "From=%2B49+2&Body=a%26b",
                   "Content-Type: application/x-www-form-urlencoded\r\n"),
            204);
  const auto events = host.take_events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(to_string(events[0].params[0]), "+49 1");
  EXPECT_EQ(events[1].params, (std::vector<Value>{"+49 2", "a&b"}));
  EXPECT_EQ(events[0].command, "Received");
  EXPECT_EQ(events[0].session, "");
  EXPECT_EQ(events[0].correlation, 0u);
}

TEST_F(WebhooksTest, AreRefused) {
  ASSERT_TRUE(start("http://a.com"));
  EXPECT_EQ(report("/inbox", "{}"), 401);
  EXPECT_EQ(report("/other?token=streng", "{}"), 404);
  EXPECT_EQ(report("/inbox?token=streng", "{}"), 422);
  EXPECT_EQ(report("/inbox?token=streng", R"({"From":1})"), 422);
  EXPECT_THAT(host.take_events(), IsEmpty());
  EXPECT_THAT(host.take_logs(),
              ElementsAre(HasSubstr("No rule applies to a report to /inbox"),
                          HasSubstr("A report to /inbox came without /Body")));
}

TEST_F(WebhooksTest, AreHeardUntilTheEnd) {
  ASSERT_TRUE(start("http://a.com"));
  EXPECT_EQ(report("/inbox", ""), 401);
  service.stop();
  EXPECT_FALSE(test::Client(address).is_connected());
}

// There nobody waits for what happens outside.
TEST_F(WebhooksTest, AreNotHeardInVirtualTimeAndWithSamples) {
  options["one-by-one"] = "true";
  ASSERT_TRUE(start("http://a.com"));
  EXPECT_THAT(host.take_logs(), IsEmpty());
  options["samples"] = "true";
  options["listen"] = "";
  ASSERT_TRUE(start("http://a.com"));
}

TEST_F(WebhooksTest, NeedAPlace) {
  options["listen"] = "";
  EXPECT_THAT(start("http://a.com").error().message,
              HasSubstr("the option 'listen' says where"));
  EXPECT_THAT(check_service(options, host.application).errors.at(0).message,
              HasSubstr("the option 'listen' says where"));
}

TEST_F(HTTPServiceTest, NeedsItsRulesAndItsSecrets) {
  HTTPService bare({});
  options["address"] = "http://a.com";
  EXPECT_THAT(to_string(bare.start(host, options).error()),
              HasSubstr("sms.xml:4: the environment has no 'KEY'"));
  folder.write("sms.xml", "<service>\n<x/></service>");
  EXPECT_THAT(to_string(start("http://a.com").error()),
              HasSubstr("sms.xml:2: <x> is not known"));
  options["rules"] = "none.xml";
  EXPECT_FALSE(start("http://a.com"));
  options["retries"] = "many";
  EXPECT_FALSE(start("http://a.com"));
}

TEST_F(HTTPServiceTest, IsDescribedByItsRules) {
  auto description = http_service_factory().description;
  EXPECT_THAT(description.roles, IsEmpty());
  options["address"] = "http://a.com";
  describe_by_rules(description, options, host.application);
  EXPECT_THAT(description.roles, ElementsAre("SMS"));
  ASSERT_EQ(description.commands.size(), 1u);
  EXPECT_EQ(description.commands[0].name, "Balance");
  EXPECT_EQ(description.events[0].name, "Balance");
}

TEST_F(HTTPServiceTest, Conforms) {
  auto factory = http_service_factory();
  options["address"] = "http://a.com";
  options["samples"] = "true";
  describe_by_rules(factory.description, options, host.application);
  EXPECT_THAT(conformance_errors(factory, {options, Milliseconds(2'000),
                                           folder.path().string(),
                                           folder.path().string()}),
              IsEmpty());
}

TEST_F(HTTPServiceTest, IsChecked) {
  options["address"] = "http://a.com";
  unsetenv("KEY");
  auto mistakes = check_service(options, host.application);
  EXPECT_THAT(mistakes.errors, IsEmpty());
  EXPECT_EQ(mistakes.missing.size(), 2u);
  options["rules"] = "none.xml";
  options["retries"] = "99";
  mistakes = check_service(options, host.application);
  EXPECT_EQ(mistakes.errors.size(), 2u);
}

} // namespace
} // namespace parlour::adapters::http
