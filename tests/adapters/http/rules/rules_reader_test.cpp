#include "adapters/http/rules/rules_reader.hpp"
#include "tests/adapters/http/rules/errors_of.hpp"

namespace parlour::adapters::http {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr auto weather = R"(<service role="Weather" address="https://w.org/v1/">
  <command name="Ask">
    <get url="/now/{place}" timeout="3s">
      <query name="day" value="{when}"/>
      <header name="X-Key" value="${KEY}"/>
    </get>
    <on>
      <event name="Report">
        <param value="{/text}, {/degrees} degrees."/>
        <param value="{/}"/>
      </event>
    </on>
    <on status="404">
      <event name="Failed"><param value="I know no {place}."/></event>
    </on>
    <sample>{"text": "Sunny", "degrees": 30}</sample>
    <sample for="Atlantis" status="404"/>
  </command>
</service>)";

TEST(RulesReader, ReadsAService) {
  const auto read = read_service_rules(weather, "a.xml", test_environment());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->rules.role, "Weather");
  EXPECT_THAT(read->missing, IsEmpty());
  const auto& command = read->rules.commands.at(0);
  EXPECT_EQ(command.request.server, "w.org");
  EXPECT_EQ(command.request.timeout, Milliseconds(3'000));
  EXPECT_THAT(command.answers, SizeIs(2));
  EXPECT_THAT(command.samples, SizeIs(2));
  EXPECT_EQ(command.answers[1].line, 13u);
}

TEST(RulesReader, AnAddressOfTheSettingsReplacesThatOfTheRules) {
  const auto read = read_service_rules(weather, "a.xml", test_environment(),
                                       "http://127.0.0.1:80");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->rules.commands[0].request.server, "127.0.0.1");
}

TEST(RulesReader, NamesWhatTheEnvironmentLacks) {
  const auto read = read_service_rules(weather, "a.xml", {});
  ASSERT_TRUE(read);
  ASSERT_THAT(read->missing, SizeIs(1));
  EXPECT_EQ(to_string(read->missing[0]),
            "a.xml:5: the environment has no 'KEY', which these rules need");
}

TEST(RulesReader, IsXml) {
  EXPECT_THAT(errors_of("<service>\n<command>"),
              ElementsAre(HasSubstr("a.xml:2: this is no XML")));
  EXPECT_THAT(errors_of(""), ElementsAre(HasSubstr("this is no XML")));
  EXPECT_THAT(errors_of("<services/>"),
              ElementsAre(HasSubstr("<service>, not <services>")));
  EXPECT_THAT(errors_of("<service/>"),
              ElementsAre(HasSubstr("has no <command> and no <webhook>")));
}

TEST(RulesReader, SaysAllThatIsWrongWithItsLine) {
  EXPECT_THAT(
      errors_of("<service address='http://a.com'>\n"
                "<command name='A' when='x'/>\n"
                "<command name='B'/>\n"
                "<command name='C'><get url='/'/><post url='/'/>\n"
                "  <on status='2x x'><event/></on>\n"
                "  <on is='b'><event name='E'/><event name='E'/></on>\n"
                "  <on has='a'><event name='E'><value/></event></on>\n"
                "  <on matches='(a'><event name='E'/></on>\n"
                "  <otherwise><event name='E'/></otherwise>\n"
                "  <on><event name='E'><param value='{a}'/></event></on>\n"
                "  <sample status='x'/><samples/>\n"
                "</command>\n"
                "<topic/></service>"),
      ElementsAre(
          HasSubstr("a.xml:2: <command> has no attribute 'when'"),
          "a.xml:3: B has no request, such as <get url=\"…\"/>",
          HasSubstr("a.xml:3: B has no <on>"),
          "a.xml:4: a command has one request, and line 4 has it",
          HasSubstr("a.xml:5: '2x' is no status such as 200"),
          HasSubstr("a.xml:5: 'x' is no status such as 200"),
          HasSubstr("a.xml:5: <event> needs the attribute 'name'"),
          HasSubstr("a.xml:6: is=\"…\" needs has"),
          HasSubstr("a.xml:6: <on> has one <event>"),
          HasSubstr("a.xml:7: has=\"…\" is a place in the answer"),
          HasSubstr("a.xml:7: <value> is not known in <event>; there are "
                    "<param>"),
          HasSubstr("a.xml:8: matches=\"…\": missing )"),
          HasSubstr("a.xml:10: behind <otherwise> nothing can apply"),
          HasSubstr("a.xml:10: '{a}' is not known here"),
          HasSubstr("a.xml:11: 'x' is no status such as 200"),
          HasSubstr("a.xml:11: <samples> is not known in <command>"),
          HasSubstr("a.xml:13: <topic> is not known in <service>")));
}

TEST(RulesReader, ParametersMayHaveOtherNames) {
  EXPECT_THAT(errors_of("<service role='SMS' address='http://a.com'>"
                        "<command name='Send' params='to, body'>"
                        "<get url='/{to}/{body}'/>"
                        "<on><event name='Sent'/></on></command></service>"),
              IsEmpty());
}

std::string with_sample(const std::string& sample) {
  return "<service address='http://a.com'><command name='A'>"
         "<get url='/'/><on has='/a'><event name='E'>"
         "<param value='{/a/b}'/></event></on>\n" +
         sample + "</command></service>";
}

TEST(RulesReader, TriesTheSamples) {
  EXPECT_THAT(errors_of(with_sample("<sample>{\"a\":{\"b\":1}}</sample>")),
              IsEmpty());
  EXPECT_THAT(errors_of(with_sample("<sample>{\"a\":{\"c\":1}}</sample>")),
              ElementsAre(HasSubstr("a.xml:2: this sample does not fit its "
                                    "rule: a.com answered without /a/b")));
  EXPECT_THAT(errors_of(with_sample("<sample>{}</sample>")),
              ElementsAre("a.xml:2: no <on> applies to this sample"));
  EXPECT_THAT(errors_of(with_sample("<sample status='500'/>")), IsEmpty());
}

TEST(RulesReader, ACommandStandsOnce) {
  const std::string command = "<command name='A'><get url='/'/>"
                              "<on><event name='E'/></on></command>";
  EXPECT_THAT(errors_of("<service address='http://a.com'>" + command + command +
                        "</service>"),
              ElementsAre(HasSubstr("there is a command A already")));
}

TEST(RulesReader, ReadsWebhooks) {
  const auto rules =
      rules_of("<webhook path='/sms'><on has='/from'><event name='Received'>"
               "<param value='{/from}'/></event></on>"
               "<sample>{\"from\": 1}</sample></webhook>");
  ASSERT_TRUE(rules.find_webhook("/sms"));
  EXPECT_EQ(rules.find_webhook("/other"), nullptr);
}

std::vector<std::string> wrong_webhook(const std::string& attributes,
                                       const std::string& children) {
  return errors_of("<service role='Telephone'><webhook " + attributes + ">\n" +
                   children + "</webhook></service>");
}

TEST(RulesReader, KnowsWebhooks) {
  const std::string on = "<on><event name='Ringing'/></on>";
  EXPECT_THAT(wrong_webhook("path='/a'", on), IsEmpty()); // though no reply
  EXPECT_THAT(wrong_webhook("", on).at(0), HasSubstr("attribute 'path'"));
  EXPECT_THAT(wrong_webhook("path='a?b'", on),
              ElementsAre(HasSubstr("begins with \"/\" and has no \"?\"")));
  EXPECT_THAT(wrong_webhook("path='/a'", ""),
              ElementsAre(HasSubstr("needs an <on>")));
  EXPECT_THAT(wrong_webhook("path='/a'", "<get url='/'/>" + on),
              ElementsAre(HasSubstr("a.xml:2: <get> is not known in "
                                    "<webhook>")));
  EXPECT_THAT(wrong_webhook("path='/a'", "<on status='200'>"
                                         "<event name='Ringing'/></on>"),
              ElementsAre(HasSubstr("<on> has no attribute 'status'")));
  EXPECT_THAT(wrong_webhook("path='/a'", "<on><event name='Ringing'>"
                                         "<param value='1'/></event></on>"),
              ElementsAre(HasSubstr("here are 1")));
  EXPECT_THAT(wrong_webhook("path='/a'", "<on has='/x'>"
                                         "<event name='Ringing'/></on>"
                                         "<sample>{}</sample>"),
              ElementsAre(HasSubstr("no <on> applies to this sample")));
  EXPECT_THAT(errors_of("<service><webhook path='/a'>" + on +
                        "</webhook><webhook path='/a'>" + on +
                        "</webhook></service>"),
              ElementsAre(HasSubstr("a webhook /a already")));
}

// A secret in a message would be in a log.
TEST(RulesReader, NoErrorQuotesTheEnvironment) {
  for (const auto& error :
       errors_of("<service address='http://${KEY}@a/'>"
                 "<command name='A'><get url='/ ${KEY}'/>"
                 "<on><event name='E'><param value='${KEY}'/></event></on>"
                 "</command></service>"))
    EXPECT_THAT(error, Not(HasSubstr("geheim")));
}

} // namespace
} // namespace parlour::adapters::http
