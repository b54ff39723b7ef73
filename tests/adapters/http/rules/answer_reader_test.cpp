#include "adapters/http/rules/answer_reader.hpp"
#include "runtime/text/json_text.hpp"
#include "tests/adapters/http/rules/rules_fixture.hpp"

namespace parlour::adapters::http {
namespace {

using testing::HasSubstr;

// The event that these rules make of an answer, as text, or the reason.
std::string event(const std::string& answers, int status,
                  const std::string& body) {
  const auto rules = rules_of("<command name='Do' params='who?'>"
                              "<get url='/'/>" +
                              answers + "</command>");
  if (rules.commands.empty())
    return "no rules";
  const auto made =
      read_answer(rules.commands[0].answers, rules.file,
                  rules.commands[0].who_answered(), {status, body}, {"Ann"});
  if (!made)
    return made.error().reason;
  return made->command + json_text(Value(made->params));
}

TEST(AnswerReader, TakesTheFirstThatApplies) {
  const auto* rules = "<on status='200 204'><event name='A'/></on>"
                      "<on status='2xx'><event name='B'/></on>"
                      "<on status='400-404'><event name='C'/></on>"
                      "<otherwise><event name='D'/></otherwise>";
  EXPECT_EQ(event(rules, 204, ""), "A[]");
  EXPECT_EQ(event(rules, 299, ""), "B[]");
  EXPECT_EQ(event(rules, 403, ""), "C[]");
  EXPECT_EQ(event(rules, 500, ""), "D[]");
}

TEST(AnswerReader, SuccessIsWhatAnOnMeansByItself) {
  EXPECT_EQ(event("<on><event name='A'/></on>", 201, ""), "A[]");
  EXPECT_EQ(event("<on><event name='A'/></on>", 404, ""),
            "a.com answered 404.");
}

TEST(AnswerReader, TakesValuesFromJson) {
  const auto* rules = "<on><event name='A'><param value='{/t}'/>"
                      "<param value='{/days/*/text}'/>"
                      "<param value='{/t} degrees for {who}: {/days/*/text}'/>"
                      "<param value='{/}'/></event></on>";
  EXPECT_EQ(
      event(rules, 200, R"({"t":2.5,"days":[{"text":"sun"},{"text":"rain"}]})"),
      R"(A[2.5,["sun","rain"],"2.5 degrees for Ann: sun, rain",)"
      R"({"t":2.5,"days":[{"text":"sun"},{"text":"rain"}]}])");
}

TEST(AnswerReader, SaysWhatTheAnswerLacks) {
  const auto* rules = "<on><event name='A'><param value='{/a/b}'/></event>"
                      "</on>";
  EXPECT_EQ(event(rules, 200, R"({"a":1})"),
            "a.com answered without /a/b, which its rule needs (a.xml:1).");
  EXPECT_EQ(event(rules, 200, "<html>"),
            "a.com answered with something that is no JSON (a.xml:1).");
  EXPECT_THAT(event(rules, 200, std::string(100, '[')),
              HasSubstr("nested too deep"));
  EXPECT_EQ(event(rules, 200, R"({"a":{"b":null}})"), "A[null]");
  EXPECT_THAT(event("<on><event name='A'><param value='x{/a}'/></event></on>",
                    200, R"({"a":null})"),
              HasSubstr("without a value at /a"));
}

TEST(AnswerReader, HasSomethingInstead) {
  const auto* rules = "<on><event name='A'><param value='{/a}' else='none'/>"
                      "<param value='a {/a}' else=''/></event></on>";
  EXPECT_EQ(event(rules, 200, "{}"), R"(A["none",""])");
  EXPECT_EQ(event(rules, 200, R"({"a":null})"), R"(A["none",""])");
  EXPECT_EQ(event(rules, 200, "no JSON"), R"(A["none",""])");
  EXPECT_EQ(event(rules, 200, R"({"a":1})"), R"(A[1,"a 1"])");
}

TEST(AnswerReader, LooksIntoTheJson) {
  const auto* rules = "<on has='/error'><event name='No'>"
                      "<param value='{/error}'/></event></on>"
                      "<on has='/state' is='queued'><event name='Later'/></on>"
                      "<on has='/n' is='3'><event name='Three'/></on>"
                      "<on><event name='Yes'/></on>";
  EXPECT_EQ(event(rules, 200, R"({"error":"full"})"), R"(No["full"])");
  EXPECT_EQ(event(rules, 200, R"({"error":null})"), "Yes[]");
  EXPECT_EQ(event(rules, 200, R"({"state":"queued"})"), "Later[]");
  EXPECT_EQ(event(rules, 200, R"({"state":"sent"})"), "Yes[]");
  EXPECT_EQ(event(rules, 200, R"({"n":3})"), "Three[]");
  EXPECT_EQ(event(rules, 200, "no JSON"), "Yes[]");
}

TEST(AnswerReader, TakesValuesFromText) {
  const auto* rules = "<on matches='^OK (\\w+)(?: in (\\d+))?'>"
                      "<event name='A'><param value='{1}'/>"
                      "<param value='{2}' else='?'/><param value='{0}'/>"
                      "</event></on>"
                      "<on><event name='B'><param value='{0}'/></event></on>";
  EXPECT_EQ(event(rules, 200, "OK taxi in 5 minutes"),
            R"(A["taxi","5","OK taxi in 5"])");
  EXPECT_EQ(event(rules, 200, "OK taxi"), R"(A["taxi","","OK taxi"])");
  EXPECT_EQ(event(rules, 200, "no"), R"(B["no"])");
  EXPECT_EQ(event(rules, 200, "caf\xe9 \xff"), R"(B["caf? ?"])");
}

TEST(AnswerReader, FindsTheSampleForAParameter) {
  const auto rules =
      rules_of("<command name='Do' params='who'><get url='/'/>"
               "<on><event name='A'/></on>"
               "<sample>{}</sample><sample for='Ann' status='404'/></command>");
  const auto& command = rules.commands.at(0);
  EXPECT_EQ(find_sample(command, {"Ann"})->answer.status, 404);
  EXPECT_EQ(find_sample(command, {"Ben"})->answer.body, "{}");
}

} // namespace
} // namespace parlour::adapters::http
