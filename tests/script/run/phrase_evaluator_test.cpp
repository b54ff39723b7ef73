#include <gtest/gtest.h>

#include "script/run/phrase_evaluator.hpp"
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
  EXPECT_EQ(evaluator->render(say("T", "S", 0)).words, "slot");
  EXPECT_EQ(evaluator->render(say("T", "R", 0)).words, "topic two shops");
  EXPECT_EQ(evaluator->render(say("U", "S", 0)).words, "any");
}

// The second time too: what holds beats what always applies.
TEST(PhraseEvaluator, PrefersAConditionThatHolds) {
  const auto evaluator = phrases("<phrase act='answer'>always</phrase>"
                                 "<phrase act='answer' if='data.n gt 1'>many"
                                 "</phrase>"
                                 "<phrase act='answer' if='data.n gt 2'>more"
                                 "</phrase>");
  EXPECT_EQ(evaluator->render(say("", "", 0)).words, "many");
  EXPECT_EQ(evaluator->render(say("", "", 1)).words, "many");
}

TEST(PhraseEvaluator, RotatesAmongEquals) {
  const auto evaluator = phrases("<phrase act='answer'>one</phrase>"
                                 "<phrase act='answer'>two</phrase>");
  EXPECT_EQ(evaluator->render(say("", "", 0)).words, "one");
  EXPECT_EQ(evaluator->render(say("", "", 1)).words, "two");
  EXPECT_EQ(evaluator->render(say("", "", 2)).words, "one");
}

TEST(PhraseEvaluator, GoesOnWithTheNextWhereOneFails) {
  const auto evaluator =
      phrases("<phrase act='answer'>any</phrase>"
              "<phrase act='answer' topic='T'>{1 / (data.n - 2)} shops</phrase>"
              "\n<phrase act='answer' topic='T' if='1 / (data.n - 2) gt 0'>many"
              "</phrase>");
  const auto [words, failures] = evaluator->render(say("T", "", 0));
  EXPECT_EQ(words, "any");
  ASSERT_EQ(failures.size(), 2u);
  EXPECT_EQ(failures[0].kind, ErrorKind::arithmetic);
  EXPECT_EQ(failures[0].place.line, failures[1].place.line + 1);
  EXPECT_FALSE(failures[1].place.file.empty());
}

TEST(PhraseEvaluator, LeavesTheTurnOfOneThatFailsToItsEqual) {
  const auto evaluator =
      phrases("<phrase act='answer'>{1 / (data.n - 2)}</phrase>"
              "<phrase act='answer'>two</phrase>");
  for (const int rotation : {0, 1, 2}) {
    const auto [words, failures] = evaluator->render(say("", "", rotation));
    EXPECT_EQ(words, "two");
    EXPECT_EQ(failures.size(), rotation == 1 ? 0u : 1u);
  }
}

} // namespace

} // namespace parlour::script
