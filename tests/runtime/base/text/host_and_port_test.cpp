#include <gtest/gtest.h>

#include "runtime/base/text/host_and_port.hpp"

namespace parlour {
namespace {

// "host|port", or "" if it has another form.
std::string read(std::string_view text) {
  const auto read = read_host_and_port(text);
  return read ? read->host + '|' + std::to_string(read->port) : "";
}

TEST(HostAndPortTest, AreParts) {
  EXPECT_EQ(read("localhost:7000"), "localhost|7000");
  EXPECT_EQ(read("192.0.2.1:80"), "192.0.2.1|80");
  EXPECT_EQ(read("[2001:db8::1]:65535"), "2001:db8::1|65535");
  EXPECT_EQ(read("[::1]:0"), "::1|0");
}

TEST(HostAndPortTest, HaveOneForm) {
  for (const auto* wrong :
       {"", ":", "localhost", "localhost:", ":80", "[]:80", "::1:80",
        "localhost:65536", "localhost:-1", "localhost:+1", "localhost: 80",
        "localhost:80 ", "local host:80", "http://localhost:80", "[[::1]]:80",
        "[::1:80", "::1]:80"})
    EXPECT_EQ(read(wrong), "") << wrong;
  EXPECT_EQ(read(std::string_view("local\0host:80", 13)), "");
}

} // namespace
} // namespace parlour
