#include <gtest/gtest.h>

#include "adapters/http/webhooks/webhook_request.hpp"

namespace parlour::adapters::http {
namespace {

ReceivedRequest post(const std::string& target,
                     const std::string& authorization = "") {
  ReceivedRequest request;
  request.method = "POST";
  request.authorization = authorization;
  set_target(request, target);
  return request;
}

TEST(WebhookRequest, IsAPost) {
  EXPECT_EQ(refusal_of(post("/"), ""), 0);
  auto get = post("/");
  get.method = "GET";
  EXPECT_EQ(refusal_of(get, ""), 405);
  EXPECT_EQ(refusal_of(get, "geheim"), 401); // who has no token learns nothing
}

TEST(WebhookRequest, NeedsItsToken) {
  EXPECT_EQ(refusal_of(post("/"), "geheim"), 401);
  EXPECT_EQ(refusal_of(post("/", "Bearer geheim"), "geheim"), 0);
  EXPECT_EQ(refusal_of(post("/?a=b&token=geheim"), "geheim"), 0);
  EXPECT_EQ(refusal_of(post("/?token=ge%68eim"), "geheim"), 0);
  for (const auto* wrong : {"Bearer ", "Bearer gehei", "Bearer geheimer",
                            "Basic geheim", "geheim", "bearer geheim"})
    EXPECT_EQ(refusal_of(post("/", wrong), "geheim"), 401) << wrong;
  EXPECT_EQ(refusal_of(post("/?token="), "geheim"), 401);
  EXPECT_EQ(refusal_of(post("/?Token=geheim"), "geheim"), 401);
}

TEST(WebhookRequest, AFormIsAnObject) {
  auto request = post("/");
  request.body = "From=%2B49+1&Body=a%26b&&empty=&flag";
  EXPECT_EQ(readable_body(request), request.body);
  request.content_type = "application/x-www-form-urlencoded; charset=utf-8";
  EXPECT_EQ(readable_body(request),
            R"({"From":"+49 1","Body":"a&b","empty":"","flag":""})");
  request.body = R"({"a":1})";
  EXPECT_EQ(readable_body(request), request.body);
}

} // namespace
} // namespace parlour::adapters::http
