#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/conversation_test/conversation_check.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;

std::vector<std::string> wrong(const std::string& text) {
  script::Program program;
  program.states.push_back({.name = "Welcome",
                            .grammar = {},
                            .messages = {},
                            .online = {},
                            .offline = {},
                            .position = {}});
  script::Topic topic;
  topic.name = "Visit";
  topic.slots.emplace_back().name = "Guest";
  program.topics.push_back(topic);
  const auto parsed = parse_conversation(text, "x.txt");
  EXPECT_TRUE(parsed.errors.empty());
  std::vector<std::string> found;
  for (const auto& finding : check_conversation(parsed.conversation, program))
    found.push_back(to_string(finding));
  return found;
}

TEST(ConversationCheck, is_content_with_what_there_is) {
  EXPECT_THAT(wrong("U: hi\nexpect state Welcome\n"
                    "expect slot Visit.Guest = Ada\n"),
              ElementsAre());
}

TEST(ConversationCheck, names_what_is_not_there_and_what_is_near) {
  EXPECT_THAT(
      wrong("U: hi\nexpect state Welcom\nexpect slot Vist.Guest = 1\n"
            "expect slot Visit.Gest = 1\n"),
      ElementsAre("x.txt:2:1: error: there is no state 'Welcom', did you mean "
                  "'Welcome'?",
                  "x.txt:3:1: error: there is no topic 'Vist', did you mean "
                  "'Visit'?",
                  "x.txt:4:1: error: there is no slot of Visit 'Gest', did "
                  "you mean 'Guest'?"));
}

} // namespace
} // namespace parlour::tools
