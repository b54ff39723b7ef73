#include <gtest/gtest.h>

#include "adapters/http/server/reply.hpp"

namespace parlour::adapters::http {
namespace {

TEST(Reply, IsAnAnswerInHTTP) {
  EXPECT_EQ(bytes_of(Reply()),
            "HTTP/1.1 204 No Content\r\nConnection: close\r\n\r\n");
  EXPECT_EQ(bytes_of(Reply{404}),
            "HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n"
            "Connection: close\r\n\r\n");
  Reply reply{200, "hello", "text/plain", "Cache-Control: no-store\r\n"};
  const std::string head = "HTTP/1.1 200 OK\r\nCache-Control: no-store\r\n"
                           "Content-Type: text/plain\r\nContent-Length: 5\r\n"
                           "Connection: close\r\n\r\n";
  EXPECT_EQ(bytes_of(reply), head + "hello");
  reply.without_text = true;
  EXPECT_EQ(bytes_of(reply), head);
}

TEST(Reply, EachStatusHasWords) {
  for (const auto status :
       {200, 204, 400, 401, 404, 405, 413, 422, 429, 431, 500, 503})
    EXPECT_NE(words_for(status), "Status") << status;
  EXPECT_EQ(words_for(418), "Status");
}

} // namespace
} // namespace parlour::adapters::http
