#include <gtest/gtest.h>

#include "adapters/mqtt/discovery/payload.hpp"

namespace parlour::adapters::mqtt {
namespace {

TEST(Payload, IsJsonOrNot) {
  const Payload json(R"({"a": [1, 2]})");
  ASSERT_NE(json.json(), nullptr);
  EXPECT_EQ((*json.json())["a"].at(1), Value(2));
  EXPECT_FALSE(json.is_broken());
  for (const auto* text : {"", "{", "ON", "{\"a\":1}x", "\xff", "[\"\xff\"]"}) {
    const Payload broken(text);
    EXPECT_EQ(broken.json(), nullptr) << text;
    EXPECT_TRUE(broken.is_broken()) << text;
  }
}

// Whoever walks a value may recurse.
TEST(Payload, MustNotBeDeep) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_FALSE(Payload(nested(10)).json() == nullptr);
  EXPECT_TRUE(Payload(nested(100)).json() == nullptr);
  EXPECT_TRUE(Payload(nested(200'000)).json() == nullptr);
  EXPECT_TRUE(Payload(std::string(200'000, '[')).json() == nullptr);
}

TEST(Payload, WritesValuesAsTemplatesDo) {
  EXPECT_EQ(text_of(true), "True");
  EXPECT_EQ(text_of(false), "False");
  EXPECT_EQ(text_of(Value()), "None");
  EXPECT_EQ(text_of("x"), "x");
  EXPECT_EQ(text_of(21.5), "21.5");
  EXPECT_EQ(text_of(List{1, "a"}), R"([1,"a"])");
}

} // namespace
} // namespace parlour::adapters::mqtt
