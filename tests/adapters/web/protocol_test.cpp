#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/web/protocol.hpp"

namespace parlour::adapters::web {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(WebProtocol, ReadsWhatVisitorsSay) {
  const auto hello = read_heard(
      R"({"type": "hello", "version": 1, "session": "a", "turn": 3, "output": 5})");
  ASSERT_TRUE(hello);
  EXPECT_EQ(std::get<Hello>(*hello).session, "a");
  EXPECT_EQ(std::get<Hello>(*hello).turn, 3);
  EXPECT_EQ(std::get<Hello>(*hello).output, 5);
  const auto turn = read_heard(R"({"type": "turn", "turn": 2, "say": "hi"})");
  ASSERT_TRUE(turn);
  EXPECT_EQ(std::get<Turn>(*turn).number, 2);
  EXPECT_THAT(std::get<Turn>(*turn).lines, ElementsAre("hi"));
  const auto row =
      read_heard(R"({"type": "turn", "turn": 2, "say": ["a", "b"]})");
  ASSERT_TRUE(row);
  EXPECT_THAT(std::get<Turn>(*row).lines, ElementsAre("a", "b"));
  EXPECT_TRUE(
      std::holds_alternative<Goodbye>(*read_heard(R"({"type":"end"})")));
  EXPECT_TRUE(std::holds_alternative<Ping>(*read_heard(R"({"type":"ping"})")));
}

TEST(WebProtocol, SaysWhatIsWrongAndWhere) {
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"{\"type\": hello}", "column 10"},
      {"", "this is no JSON"},
      {"[1]", "a message is an object"},
      {"{}", "\"type\" is"},
      {"{\"type\": 3}", "\"type\" is"},
      {"{\"type\": \"hello\", \"version\": 2}", "version 1"},
      {"{\"type\": \"hello\", \"session\": 2}", "\"session\" is the text"},
      {"{\"type\": \"hello\", \"turn\": -1}", "\"turn\" is a whole number"},
      {"{\"type\": \"turn\", \"say\": \"a\"}", "has a number from 1"},
      {"{\"type\": \"turn\", \"turn\": 1}", "\"say\" is a text"},
      {"{\"type\": \"turn\", \"turn\": 1, \"say\": []}", "\"say\" is a text"},
      {"{\"type\": \"turn\", \"turn\": 1, \"say\": [1]}", "\"say\" is a text"},
      {"{\"type\": \"turn\", \"turn\": 18446744073709551615, \"say\": \"a\"}",
       "\"turn\" is a whole number"},
      {"{\"type\": \"\xff\"}", "byte 11 is no UTF-8"},
      {std::string(5'000, '['), "this is no JSON"},
  };
  for (const auto& [text, what] : mistakes) {
    const auto read = read_heard(text);
    ASSERT_FALSE(read) << text;
    EXPECT_THAT(read.error().message, HasSubstr(what));
  }
}

TEST(WebProtocol, ReadsWhatIsTyped) {
  EXPECT_EQ(*read_typed("hello\r"), "hello");
  EXPECT_THAT(read_typed("ab\xff").error().message, HasSubstr("byte 3"));
  EXPECT_TRUE(is_structured("{\"type\""));
  EXPECT_FALSE(is_structured("hello"));
}

TEST(WebProtocol, WritesForPrograms) {
  EXPECT_EQ(to_json(Said{1, 2, "answer", "\"Hi\"\n"}),
            R"({"type": "say", "turn": 1, "output": 2, "act": "answer", )"
            R"("text": "\"Hi\"\n"})");
  EXPECT_EQ(to_json(Done{4}), R"({"type": "done", "turn": 4})");
  EXPECT_EQ(to_json(Ended()), R"({"type": "end"})");
  EXPECT_EQ(to_json(Pong()), R"({"type": "pong"})");
  EXPECT_EQ(to_json(Refused{"full", "later"}),
            R"({"type": "error", "code": "full", "message": "later"})");
}

TEST(WebProtocol, WritesForPeople) {
  EXPECT_EQ(to_line(Said{1, 2, "answer", "one\ntwo"}), "one two");
  EXPECT_EQ(to_line(Refused{"full", "try again later"}), "! try again later");
  EXPECT_EQ(to_line(Done{1}), "");
}

} // namespace
} // namespace parlour::adapters::web
