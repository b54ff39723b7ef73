#include <string>

#include <gtest/gtest.h>

#include "adapters/network/address.hpp"

namespace parlour::adapters {
namespace {

std::string read(const std::string& text) {
  const auto address = parse_address(text);
  return address ? address->host + "|" + address->port : "error";
}

TEST(Address, HasAHostAndAPort) {
  EXPECT_EQ(read("localhost:80"), "localhost|80");
  EXPECT_EQ(read("192.0.2.1:65535"), "192.0.2.1|65535");
  EXPECT_EQ(read("[::1]:1"), "::1|1");
}

TEST(Address, IsNothingElse) {
  for (const std::string text :
       {"", ":", "localhost", "localhost:", ":80", "localhost:0",
        "localhost:65536", "localhost:80x", "localhost:-1", "::1:80", "[]:80",
        "a b:80", "http://a:80"})
    EXPECT_EQ(read(text), "error") << text;
  EXPECT_NE(parse_address("x").error().message.find("host:port"),
            std::string::npos);
}

} // namespace
} // namespace parlour::adapters
