#include <gtest/gtest.h>

#include "script/phrase_evaluator.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

std::shared_ptr<const PhraseEvaluator> phrases(const std::string& text) {
  auto outcome = test::compile_declarations("<phrases>" + text +
                                            "</phrases><topic name='T'>"
                                            "<slot name='S'/></topic>");
  EXPECT_TRUE(outcome.program)
      << (outcome.lines.empty() ? "" : outcome.lines[0]);
  return make_phrase_evaluator(outcome.program);
}

Value say(const std::string& topic, const std::string& slot, int rotation) {
  return Map{{"act", "answer"},
             {"topic", topic},
             {"slot", slot},
             {"data", Map{{"n", 2}}},
             {"rotation", rotation}};
}

TEST(PhraseEvaluator, TakesTheMostSpecificThatHolds) {
  const auto evaluator =
      phrases("<phrase act='answer'>any</phrase>"
              "<phrase act='answer' topic='T'>topic {count(data.n, 'shop')}"
              "</phrase>"
              "<phrase act='answer' topic='T' slot='S' if='data.n gt 1'>slot"
              "</phrase>"
              "<phrase act='answer' topic='T' slot='S' if='data.n gt 2'>never"
              "</phrase>");
  EXPECT_EQ(evaluator->render(say("T", "S", 0)), "slot");
  EXPECT_EQ(evaluator->render(say("T", "R", 0)), "topic two shops");
  EXPECT_EQ(evaluator->render(say("U", "S", 0)), "any");
}

// The second time too: what holds beats what always applies.
TEST(PhraseEvaluator, PrefersAConditionThatHolds) {
  const auto evaluator = phrases("<phrase act='answer'>always</phrase>"
                                 "<phrase act='answer' if='data.n gt 1'>many"
                                 "</phrase>"
                                 "<phrase act='answer' if='data.n gt 2'>more"
                                 "</phrase>");
  EXPECT_EQ(evaluator->render(say("", "", 0)), "many");
  EXPECT_EQ(evaluator->render(say("", "", 1)), "many");
}

TEST(PhraseEvaluator, RotatesAmongEquals) {
  const auto evaluator = phrases("<phrase act='answer'>one</phrase>"
                                 "<phrase act='answer'>two</phrase>");
  EXPECT_EQ(evaluator->render(say("", "", 0)), "one");
  EXPECT_EQ(evaluator->render(say("", "", 1)), "two");
  EXPECT_EQ(evaluator->render(say("", "", 2)), "one");
}

} // namespace

} // namespace parlour::script
