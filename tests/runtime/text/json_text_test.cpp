#include <gtest/gtest.h>

#include "runtime/text/json_text.hpp"

namespace parlour {
namespace {

std::string again(std::string_view json) {
  const auto value = read_json(json);
  return value ? json_text(*value) : "no JSON";
}

TEST(JsonText, IsReadAndWritten) {
  for (const auto* text :
       {"null", "true", "false", "0", "-12", "2.5", "\"a\\\"b\"", "[]", "{}",
        "[1,[2,\"x\"],{\"a\":null}]", "{\"b\":1,\"a\":{\"c\":[true]}}"})
    EXPECT_EQ(again(text), text);
  EXPECT_EQ(again(" { \"a\" : [ 1 , 2 ] } "), "{\"a\":[1,2]}");
}

TEST(JsonText, KeepsTypes) {
  EXPECT_EQ(read_json("7")->type(), ValueType::integer);
  EXPECT_EQ(read_json("7.0")->type(), ValueType::number);
  EXPECT_EQ(read_json("18446744073709551615")->type(), ValueType::number);
  EXPECT_EQ(read_json("\"7\"")->type(), ValueType::string);
  EXPECT_EQ(read_json("{\"a\":1,\"a\":2}").value(), Value(Map{{"a", 2}}));
}

TEST(JsonText, RowsAreObjects) {
  const ResultSet rows{{"name", "room"}, {"Ann", 5, "Bo", Value()}};
  EXPECT_EQ(json_text(rows),
            R"([{"name":"Ann","room":5},{"name":"Bo","room":null}])");
  // select a.name, b.name, a.id, b.id as ID
  EXPECT_EQ(
      json_text(ResultSet{{"name", "name", "id", "ID"}, {"a", "b", 1, 2}}),
      R"([{"name":"a","name_2":"b","id":1,"ID":2}])");
}

TEST(JsonText, ReplacesWhatIsNoUtf8) {
  EXPECT_EQ(json_text("a\xff"), "\"a\xef\xbf\xbd\"");
}

TEST(JsonText, SaysWhatIsNoJson) {
  for (const auto* text :
       {"", "{", "[1,]", "nul", "{\"a\"}", "1 2", "'a'", "\"a\xff\"", "1e999"})
    EXPECT_EQ(read_json(text).error(), JsonFault::not_json) << text;
}

TEST(JsonText, BoundsTheDepth) {
  auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_TRUE(read_json(nested(json_depth)));
  EXPECT_EQ(read_json(nested(json_depth + 1)).error(), JsonFault::too_deep);
  EXPECT_EQ(read_json(std::string(1 << 20, '[')).error(), JsonFault::too_deep);
  // A second try is not influenced by the first.
  EXPECT_TRUE(read_json(nested(json_depth)));
}

// An object that is searched key by key would take minutes.
TEST(JsonText, ReadsLargeObjectsInLinearTime) {
  std::string text = "{";
  for (int i = 0; i < 200'000; ++i)
    text += (i ? ",\"k" : "\"k") + std::to_string(i) + "\":1";
  const auto value = read_json(text + "}");
  ASSERT_TRUE(value);
  EXPECT_EQ(value->if_map()->size(), 200'000u);
}

} // namespace
} // namespace parlour
