#include <gmock/gmock.h>

#include "adapters/http/message/http_address.hpp"

namespace parlour::adapters::http {
namespace {

using testing::HasSubstr;

std::string error_of(std::string_view text) {
  const auto read = read_address(text);
  return read ? "" : read.error();
}

TEST(HttpAddress, IsTakenApart) {
  const auto address = read_address("HTTPS://API.Example.com/v1/a?b=c/d");
  ASSERT_TRUE(address);
  EXPECT_EQ(address->scheme, "https");
  EXPECT_EQ(address->host, "api.example.com");
  EXPECT_EQ(address->port, 443);
  EXPECT_EQ(address->target, "/v1/a?b=c/d");
  EXPECT_EQ(address->server(), "api.example.com");
}

TEST(HttpAddress, HasAPortAndATarget) {
  EXPECT_EQ(read_address("http://a:8080")->server(), "a:8080");
  EXPECT_EQ(read_address("http://a:80")->server(), "a");
  EXPECT_EQ(read_address("http://a?b")->target, "/?b");
  EXPECT_EQ(read_address("http://[::1]:81/x")->host, "[::1]");
  EXPECT_EQ(read_address("http://[::1]")->port, 80);
}

TEST(HttpAddress, SaysWhatIsWrong) {
  for (const auto* text : {"", "a.com", "/a", "ftp://a", "file:///etc/passwd"})
    EXPECT_THAT(error_of(text), HasSubstr("neither http:// nor https://"));
  for (const auto* text :
       {"http://", "http:///a", "http://a:", "http://a:0", "http://a:70000",
        "http://a:8x", "http://[::1", "http://a\\b", "http://a:1:2"})
    EXPECT_THAT(error_of(text), HasSubstr("no server")) << text;
  EXPECT_THAT(error_of("http://user:secret@a/"), HasSubstr("<header"));
  EXPECT_THAT(error_of("http://user:secret@a/"), Not(HasSubstr("secret")));
  EXPECT_THAT(error_of("http://a/b c"), HasSubstr("%XX"));
  EXPECT_THAT(error_of("http://a/b\r\nc"), HasSubstr("%XX"));
  EXPECT_THAT(error_of("http://a/b#c"), HasSubstr("'#'"));
}

TEST(HttpAddress, KnowsItsOrigin) {
  const auto one = read_address("https://a.com/x");
  EXPECT_TRUE(one->same_origin(*read_address("https://A.com:443/y")));
  EXPECT_FALSE(one->same_origin(*read_address("http://a.com:443/x")));
  EXPECT_FALSE(one->same_origin(*read_address("https://a.com:444/x")));
  EXPECT_FALSE(one->same_origin(*read_address("https://b.a.com/x")));
}

TEST(HttpAddress, ValuesAreEncoded) {
  EXPECT_EQ(percent_encoded("Az09-._~"), "Az09-._~");
  EXPECT_EQ(percent_encoded("a/b?c&d=e f%"), "a%2Fb%3Fc%26d%3De%20f%25");
  EXPECT_EQ(percent_encoded("\xc3\xa9\r\n"), "%C3%A9%0D%0A");
}

TEST(HttpAddress, DotSegmentsAreFound) {
  EXPECT_TRUE(has_dot_segment("/a/../b"));
  EXPECT_TRUE(has_dot_segment("/.."));
  EXPECT_TRUE(has_dot_segment("/a/./b?c"));
  EXPECT_FALSE(has_dot_segment("/a/...?b=/../"));
  EXPECT_FALSE(has_dot_segment("/a.b/.c"));
}

} // namespace
} // namespace parlour::adapters::http
