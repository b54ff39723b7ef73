#include <gtest/gtest.h>

#include "adapters/http/server/received_request.hpp"

namespace parlour::adapters::http {
namespace {

ReceivedRequest request_for(const std::string& target) {
  ReceivedRequest request;
  set_target(request, target);
  return request;
}

TEST(ReceivedRequest, HasAPathAndAQuery) {
  const auto request = request_for("/a%20b/c+d?x=%20&y");
  EXPECT_EQ(request.path, "/a b/c+d");
  EXPECT_EQ(request.query, "x=%20&y");
  EXPECT_EQ(request_for("/a?").query, "");
  EXPECT_EQ(request_for("/%4").path, "/%4");
  EXPECT_EQ(request_for("/%-1%zz").path, "/%-1%zz");
}

TEST(ReceivedRequest, DecodesForms) {
  EXPECT_EQ(form_decoded("%2B49+1"), "+49 1");
  EXPECT_EQ(form_decoded("100%"), "100%");
}

} // namespace
} // namespace parlour::adapters::http
