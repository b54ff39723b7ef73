#include "adapters/http/rules/request_maker.hpp"
#include "tests/adapters/http/rules/rules_fixture.hpp"

namespace parlour::adapters::http {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

tl::expected<HttpRequest, std::string> made(const std::string& params,
                                            const std::string& request,
                                            const List& values) {
  const auto rules = request_rules(params, request);
  if (rules.commands.empty())
    return tl::make_unexpected("no rules");
  return make_request(rules.commands[0], values, "id-7");
}

std::string address(const std::string& url, const List& values) {
  const auto request = made("a, b?", "<get url='" + url + "'/>", values);
  return request ? request->address : request.error();
}

TEST(RequestMaker, ValuesInAddressesAreEncoded) {
  EXPECT_EQ(address("/x/{a}?q={b}", {"a/b?c#d", "1&2=3"}),
            "http://a.com/x/a%2Fb%3Fc%23d?q=1%262%3D3");
  EXPECT_EQ(address("/x/{a}", {7}), "http://a.com/x/7");
  EXPECT_EQ(address("${HOST}/k/${KEY}/{a}", {"\r\n"}),
            "http://a.com/k/geheim%2F1/%0D%0A");
}

TEST(RequestMaker, AnAddressCannotLeaveItsPath) {
  EXPECT_THAT(address("/x/{a}/y", {".."}), HasSubstr("cannot be a part"));
  EXPECT_THAT(address("/x/{a}{b}/y", {".", "."}),
              HasSubstr("cannot be a part"));
  EXPECT_THAT(address("/x/{a}/y", {""}), HasSubstr("'a' is empty"));
  EXPECT_EQ(address("/x/{a}", {"..."}), "http://a.com/x/...");
  EXPECT_EQ(address("/x?a={a}", {".."}), "http://a.com/x?a=..");
}

TEST(RequestMaker, WhatIsNotGivenIsLeftOut) {
  const auto request =
      made("a, b?",
           "<get url='/x?y'><query name='a' value='{a}'/>"
           "<query name='b' value='{b}'/><query name='c' value='c{b}'/>"
           "<header name='B' value='{b}'/></get>",
           {"1"});
  ASSERT_TRUE(request);
  EXPECT_EQ(request->address, "http://a.com/x?y&a=1&c=c");
  EXPECT_THAT(request->headers, ElementsAre());
}

TEST(RequestMaker, NeedsWhatIsNotOptional) {
  EXPECT_EQ(address("/x", {}), "Do needs 'a'.");
  EXPECT_EQ(address("/x", {Value()}), "Do needs 'a'.");
}

TEST(RequestMaker, HeadersHaveOneLine) {
  const auto* rule = "<get url='/'><header name='X' value='a {a}'/>"
                     "<header name='Authorization' value='Bearer ${KEY}'/>"
                     "</get>";
  const auto request = made("a", rule, {"b"});
  ASSERT_TRUE(request);
  EXPECT_THAT(
      request->headers,
      ElementsAre(HttpHeader{"X", "a b", false},
                  HttpHeader{"Authorization", "Bearer geheim/1", true}));
  for (const auto* value : {"b\r\nEvil: 1", "b\n", "b\x7f"})
    EXPECT_THAT(made("a", rule, {value}).error(), HasSubstr("line ends"));
  EXPECT_THAT(made("a", rule, {std::string("b\0c", 3)}).error(),
              HasSubstr("control characters"));
}

TEST(RequestMaker, ValuesInJsonAreJson) {
  const auto* rule =
      R"(<post url='/'><body type='json'>{"to": "{a}", "n": {b}}</body></post>)";
  auto body = [&](const List& values) {
    return made("a, b?", rule, values)->body;
  };
  EXPECT_EQ(body({"x", 3}), R"({"to": "x", "n": 3})");
  EXPECT_EQ(body({"\",\"evil\":\"", "t"}),
            R"({"to": "\",\"evil\":\"", "n": "t"})");
  EXPECT_EQ(body({"a\nb", List{1, "c"}}), R"({"to": "a\nb", "n": [1,"c"]})");
  EXPECT_EQ(body({3, Value()}), R"({"to": "3", "n": null})");
  const auto request = made("a, b?", rule, {"x"});
  EXPECT_THAT(request->headers,
              ElementsAre(HttpHeader{"Content-Type", "application/json"}));
}

TEST(RequestMaker, FormsXmlAndTextHaveTheirOwnSigns) {
  const auto form = made("a",
                         "<post url='/'><field name='to' value='{a}'/>"
                         "<field name='n m' value='1'/></post>",
                         {"+49 1&2"});
  EXPECT_EQ(form->body, "to=%2B49%201%262&n%20m=1");
  EXPECT_EQ(form->headers[0].value, "application/x-www-form-urlencoded");
  const auto xml = made("a",
                        "<put url='/'><body type='xml'>"
                        "<![CDATA[<to n=\"{a}\"/>]]></body></put>",
                        {"<&\"'>\x01"});
  EXPECT_EQ(xml->body, "<to n=\"&lt;&amp;&quot;&apos;&gt; \"/>");
  const auto text =
      made("a", "<patch url='/'><body type='text'>\n Hi {a}! </body></patch>",
           {"<b>"});
  EXPECT_EQ(text->body, "Hi <b>!");
}

TEST(RequestMaker, KnowsWhatMayBeRepeated) {
  auto may_repeat = [](const std::string& request) {
    return made("a", request, {"1"})->may_repeat;
  };
  EXPECT_TRUE(may_repeat("<get url='/'/>"));
  EXPECT_TRUE(may_repeat("<put url='/'/>"));
  EXPECT_FALSE(may_repeat("<post url='/'/>"));
  EXPECT_FALSE(may_repeat("<patch url='/'/>"));
  EXPECT_TRUE(may_repeat("<post url='/' retry='yes'/>"));
  EXPECT_FALSE(may_repeat("<get url='/' retry='no'/>"));
  const std::string key =
      "<header name='idempotency-Key' value='{request.id}'/></post>";
  EXPECT_TRUE(may_repeat("<post url='/'>" + key));
  EXPECT_FALSE(may_repeat("<post url='/' retry='no'>" + key));
  EXPECT_EQ(made("a", "<post url='/'>" + key, {"1"})->headers[0].value, "id-7");
}

TEST(RequestMaker, BoundsWhatIsSent) {
  EXPECT_THAT(address("/{a}", {std::string(max_address, 'x')}),
              HasSubstr("too long"));
  EXPECT_THAT(made("a", "<post url='/'><body type='text'>{a}</body></post>",
                   {std::string(max_body + 1, 'x')})
                  .error(),
              HasSubstr("too long"));
}

} // namespace
} // namespace parlour::adapters::http
