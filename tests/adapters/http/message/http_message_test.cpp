#include <gtest/gtest.h>

#include "adapters/http/message/http_message.hpp"

namespace parlour::adapters::http {

TEST(HttpMessage, MethodsHaveNamesAndAreIdempotentOrNot) {
  EXPECT_EQ(name_of(Method::get), "GET");
  EXPECT_EQ(name_of(Method::remove), "DELETE");
  EXPECT_TRUE(is_idempotent(Method::put));
  EXPECT_TRUE(is_idempotent(Method::remove));
  EXPECT_FALSE(is_idempotent(Method::post));
  EXPECT_FALSE(is_idempotent(Method::patch));
}

} // namespace parlour::adapters::http
