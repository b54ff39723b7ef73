#include "adapters/http/rules/request_reader.hpp"
#include "tests/adapters/http/rules/errors_of.hpp"

namespace parlour::adapters::http {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// The mistakes in one request; the command has the parameters a and b.
std::vector<std::string> wrong(const std::string& request,
                               const std::string& address = "http://a.com") {
  return errors_of("<service address='" + address +
                   "'><command name='A' params='a, b?'>\n" + request +
                   "<on><event name='E'/></on></command></service>");
}

TEST(RequestReader, KnowsItsElements) {
  EXPECT_EQ(method_of_element("delete"), Method::remove);
  EXPECT_EQ(method_of_element("head"), std::nullopt);
}

TEST(RequestReader, AnAddressMayStandInSeveralPlaces) {
  EXPECT_THAT(wrong("<get url='/x'/>", "${HOST}"), IsEmpty());
  EXPECT_THAT(wrong("<get url='/x'/>", "http://${KEYLESS}.com/v1"), IsEmpty());
  EXPECT_THAT(wrong("<get url='${HOST}/x'/>", ""), IsEmpty());
  EXPECT_THAT(wrong("<get url='https://b.com?q={a}'/>"), IsEmpty());
}

TEST(RequestReader, TheServerIsKnownFromTheBeginning) {
  EXPECT_THAT(wrong("<get url='http://{a}.com/'/>"),
              ElementsAre(HasSubstr("cannot depend on a parameter")));
  EXPECT_THAT(wrong("<get url='{a}'/>"),
              ElementsAre(HasSubstr("neither http:// nor https://")));
  EXPECT_THAT(wrong("<get url='/x'/>", ""),
              ElementsAre(HasSubstr("the service has no address")));
  EXPECT_THAT(wrong("<get url='file:///etc/passwd'/>"),
              ElementsAre(HasSubstr("neither http:// nor https://")));
  EXPECT_THAT(wrong("<get url='http://u:p@b.com/'/>"),
              ElementsAre(HasSubstr("<header name=\"Authorization\">")));
  EXPECT_THAT(wrong("<get url='${HOST'/>"),
              ElementsAre(HasSubstr("${ without its }")));
}

TEST(RequestReader, AnAddressIsEncoded) {
  EXPECT_THAT(wrong("<get url='/a b'/>"), ElementsAre(HasSubstr("%XX")));
  EXPECT_THAT(wrong("<get url='/../x'/>"),
              ElementsAre(HasSubstr("cannot be a part of an address")));
}

TEST(RequestReader, BodiesAreOfTheirType) {
  EXPECT_THAT(wrong("<post url='/'><body type='json'>{\"a\": {a}}</body>"
                    "</post>"),
              IsEmpty());
  EXPECT_THAT(wrong("<post url='/'><body type='json'>{a: 1}</body></post>"),
              ElementsAre(HasSubstr("the body is no JSON")));
  EXPECT_THAT(wrong("<post url='/'><body type='yaml'/></post>"),
              ElementsAre(HasSubstr("there are json, xml and text")));
  EXPECT_THAT(wrong("<post url='/'><body type='text'/><body type='text'/>"
                    "</post>"),
              ElementsAre(HasSubstr("one <body>")));
  EXPECT_THAT(wrong("<post url='/'><body type='text'/><field name='x'/>"
                    "</post>"),
              ElementsAre(HasSubstr("or a <body>, not both")));
  EXPECT_THAT(wrong("<get url='/'><field name='x'/></get>"),
              ElementsAre(HasSubstr("a GET has no body")));
  EXPECT_THAT(wrong("<delete url='/'><body type='text'/></delete>"),
              ElementsAre(HasSubstr("a DELETE has no body")));
}

TEST(RequestReader, HeadersHaveNames) {
  EXPECT_THAT(wrong("<get url='/'><header name='a b' value='x'/></get>"),
              ElementsAre(HasSubstr("no name of a header")));
  EXPECT_THAT(wrong("<get url='/'><header name='host' value='x'/></get>"),
              ElementsAre(HasSubstr("written by the platform itself")));
  EXPECT_THAT(wrong("<get url='/'><header name='X' value='a&#10;b'/></get>"),
              ElementsAre(HasSubstr("line ends")));
}

TEST(RequestReader, HasItsTerms) {
  EXPECT_THAT(wrong("<get url='/' timeout='soon'/>"),
              ElementsAre(HasSubstr("no time such as 500ms")));
  EXPECT_THAT(wrong("<get url='/' timeout='0s'/>"),
              ElementsAre(HasSubstr("no time such as 500ms")));
  EXPECT_THAT(wrong("<get url='/' retry='maybe'/>"),
              ElementsAre(HasSubstr("\"yes\" or \"no\"")));
  EXPECT_THAT(wrong("<get/>"), ElementsAre(HasSubstr("needs the attribute")));
  EXPECT_THAT(wrong("<get url='/'><on/></get>"),
              ElementsAre(HasSubstr("<on> is not known in <get>")));
  EXPECT_THAT(wrong("<get url='/'><query name='x' value='{c}'/></get>"),
              ElementsAre(HasSubstr("'{c}' is not known here; there are {a}")));
}

} // namespace
} // namespace parlour::adapters::http
