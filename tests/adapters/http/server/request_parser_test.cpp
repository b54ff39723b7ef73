#include <gtest/gtest.h>

#include "adapters/http/server/request_parser.hpp"

namespace parlour::adapters::http {
namespace {

constexpr std::string_view complete =
    "POST /sms?a=b HTTP/1.1\r\nHost: x\r\nContent-Type: text/plain\r\n"
    "authorization: Bearer t\r\nContent-Length: 5\r\n\r\nhello";

int take(std::string_view bytes, std::size_t max_body = 100) {
  return make_request_parser(max_body)->take(bytes);
}

TEST(RequestParser, ReadsARequest) {
  const auto parser = make_request_parser(100);
  ASSERT_TRUE(parser);
  EXPECT_EQ(parser->take(complete), 200);
  const auto request = parser->request();
  EXPECT_EQ(request.method, "POST");
  EXPECT_EQ(request.path, "/sms");
  EXPECT_EQ(request.query, "a=b");
  EXPECT_EQ(request.content_type, "text/plain");
  EXPECT_EQ(request.authorization, "Bearer t");
  EXPECT_EQ(request.body, "hello");
}

TEST(RequestParser, TakesBytesAsTheyCome) {
  const auto parser = make_request_parser(100);
  for (std::size_t i = 0; i + 1 < complete.size(); ++i)
    ASSERT_EQ(parser->take(complete.substr(i, 1)), 0) << i;
  EXPECT_EQ(parser->take("o"), 200);
  EXPECT_EQ(parser->request().body, "hello");
}

TEST(RequestParser, ReadsABodyInChunks) {
  const auto parser = make_request_parser(100);
  EXPECT_EQ(parser->take("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n"
                         "3\r\nabc\r\n2\r\nde\r\n0\r\n\r\n"),
            200);
  EXPECT_EQ(parser->request().body, "abcde");
}

TEST(RequestParser, IgnoresWhatFollows) {
  EXPECT_EQ(take(std::string(complete) + "GET / HTTP/1.1\r\n\r\n"), 200);
}

TEST(RequestParser, SaysWhatIsWrong) {
  EXPECT_EQ(take("hello\r\n\r\n"), 400);
  EXPECT_EQ(take("POST / HTTP/1.1\r\nContent-Length: x\r\n\r\n"), 400);
  EXPECT_EQ(take("POST / HTTP/1.1\r\nContent-Length: 3\r\n"
                 "Content-Length: 4\r\n\r\n"),
            400);
  EXPECT_EQ(take("POST / HTTP/9\r\n\r\n"), 400);
  EXPECT_EQ(take(std::string("\0\0\0\0", 4) + "\r\n\r\n"), 400);
  EXPECT_EQ(take("POST / HTTP/1.1\r\nContent-Length: 101\r\n\r\n"), 413);
  EXPECT_EQ(take("POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n"
                 "80\r\n" +
                 std::string(128, 'x')),
            413);
  EXPECT_EQ(take("POST / HTTP/1.1\r\nX: " + std::string(9'000, 'x')), 431);
  EXPECT_EQ(take("POST /" + std::string(9'000, 'x')), 431);
}

} // namespace
} // namespace parlour::adapters::http
