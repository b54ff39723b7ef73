#include <gmock/gmock.h>

#include "adapters/http/policy/redirect_policy.hpp"

namespace parlour::adapters::http {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

HttpAnswer to(const std::string& address, int status = 302) {
  return {status, "", {}, address};
}

HttpRequest request(Method method) {
  return {method,
          "https://a.com/x",
          {{"Accept", "text/plain"},
           {"X-Key", "secret", true},
           {"Content-Type", "application/json"}},
          "{}",
          method == Method::get};
}

TEST(RedirectPolicy, KnowsWhatCanBeFollowed) {
  for (const auto status : {301, 302, 303, 307, 308})
    EXPECT_TRUE(is_redirect(to("https://a.com/y", status)));
  EXPECT_FALSE(is_redirect(to("https://a.com/y", 304)));
  EXPECT_FALSE(is_redirect(to("", 302)));
}

TEST(RedirectPolicy, AGetGoesOnOnItsServer) {
  const auto next = redirected(request(Method::get), to("https://a.com:443/y"));
  ASSERT_TRUE(next);
  EXPECT_EQ(next->address, "https://a.com:443/y");
  EXPECT_EQ(next->headers, request(Method::get).headers);
}

TEST(RedirectPolicy, SecretsStayOnTheirServer) {
  for (const auto* address : {"https://b.com/", "https://a.com:8443/"}) {
    const auto next = redirected(request(Method::get), to(address));
    ASSERT_TRUE(next);
    for (const auto& header : next->headers)
      EXPECT_NE(header.name, "X-Key");
    EXPECT_EQ(next->headers.size(), 2u);
  }
}

TEST(RedirectPolicy, APostBecomesAGetUnlessToldToStay) {
  const auto get = redirected(request(Method::post), to("https://a.com/y"));
  ASSERT_TRUE(get);
  EXPECT_EQ(get->method, Method::get);
  EXPECT_EQ(get->body, "");
  EXPECT_EQ(get->headers.size(), 2u); // no Content-Type
  const auto post =
      redirected(request(Method::post), to("https://a.com/y", 307));
  ASSERT_TRUE(post);
  EXPECT_EQ(post->method, Method::post);
  EXPECT_EQ(post->body, "{}");
  EXPECT_FALSE(post->may_repeat);
}

TEST(RedirectPolicy, RefusesTheRest) {
  EXPECT_THAT(redirected(request(Method::post), to("https://b.com/")).error(),
              HasSubstr("another server, b.com"));
  EXPECT_THAT(redirected(request(Method::get), to("http://a.com/x")).error(),
              HasSubstr("from https to http"));
  EXPECT_THAT(redirected(request(Method::get), to("ftp://a.com/x")).error(),
              HasSubstr("cannot be used"));
  EXPECT_THAT(
      redirected(request(Method::get), to("https://u:p@a.com/x")).error(),
      HasSubstr("cannot be used"));
}

} // namespace
} // namespace parlour::adapters::http
