#include <gtest/gtest.h>

#include "adapters/http/rules/json_path.hpp"
#include "runtime/text/json_text.hpp"

namespace parlour::adapters::http {
namespace {

// What is there, as JSON; "nothing" if nothing is.
std::string at(std::string_view path, std::string_view json) {
  const auto found = JsonPath(path).find(read_json(json).value());
  return found ? json_text(*found) : "nothing";
}

constexpr auto days = R"({"days":[{"text":"sun","hours":[1,2]},
                                  {"text":"rain","hours":[3]},{"hours":[]}]})";

TEST(JsonPath, LeadsThroughObjectsAndLists) {
  EXPECT_EQ(at("/days/1/text", days), "\"rain\"");
  EXPECT_EQ(at("/days/0/hours/1", days), "2");
  EXPECT_EQ(at("/a", R"({"a":null})"), "null");
  EXPECT_EQ(at("/", "[1]"), "[1]");
  EXPECT_EQ(at("/0", R"({"0":"a key"})"), "\"a key\"");
  EXPECT_EQ(JsonPath("/days/1").text(), "/days/1");
}

TEST(JsonPath, FindsNothing) {
  for (const auto* path : {"/b", "/days/3", "/days/-1", "/days/x", "/days/01x",
                           "/days/0/text/a", "/days/",
                           "/days/99999999999999999"
                           "999999"})
    EXPECT_EQ(at(path, days), "nothing") << path;
}

TEST(JsonPath, AStarIsEach) {
  EXPECT_EQ(at("/days/*/text", days), R"(["sun","rain"])");
  EXPECT_EQ(at("/days/*/hours/*", days), "[1,2,3]");
  EXPECT_EQ(at("/*", R"({"a":1,"b":2})"), "[1,2]");
  EXPECT_EQ(at("/days/*/none", days), "[]");
  EXPECT_EQ(at("/days/0/text/*", days), "nothing");
}

TEST(JsonPath, KeysMayHaveAnySign) {
  EXPECT_EQ(at("/a~1b", R"({"a/b":1})"), "1");
  EXPECT_EQ(at("/m~0n", R"({"m~n":1})"), "1");
  EXPECT_EQ(at("/a b", R"({"a b":1})"), "1");
}

} // namespace
} // namespace parlour::adapters::http
