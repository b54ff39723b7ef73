#include <gtest/gtest.h>

#include "script/dialogue/agenda/output_queue.hpp"

namespace parlour::dialogue {

namespace {

Output make(OutputAct act, std::string text,
            OutputState state = OutputState::pending) {
  Output output;
  output.act = act;
  output.text = std::move(text);
  output.state = state;
  return output;
}

std::vector<std::string> texts(std::span<const Output> outputs) {
  std::vector<std::string> texts;
  for (const auto& output : outputs)
    texts.push_back(output.text);
  return texts;
}

using Texts = std::vector<std::string>;

// A robot that nobody answers speaks on and on.
TEST(OutputQueue, RemembersTheNewestOfALongTurn) {
  OutputQueue queue;
  for (int i = 1; i <= 200; ++i) {
    const auto id = queue.push(make(OutputAct::answer, std::to_string(i)));
    queue.release(false);
    queue.cut(id, "part of " + std::to_string(i));
  }
  EXPECT_EQ(queue.last_turn().size(), 64u);
  EXPECT_EQ(queue.last_turn().front(), "part of 137");
  EXPECT_EQ(queue.last_turn().back(), "part of 200");
  EXPECT_FALSE(queue.released(100));
}

TEST(OutputQueue, ReleasesAllOfWhatIsSaidAtOnce) {
  OutputQueue queue;
  for (int i = 1; i <= 200; ++i)
    queue.push(make(OutputAct::answer, std::to_string(i)));
  EXPECT_EQ(queue.release(false).released.size(), 200u);
  EXPECT_EQ(queue.last_turn().size(), 64u);
}

TEST(OutputQueue, ReleasesInOrder) {
  OutputQueue queue;
  EXPECT_TRUE(queue.empty());
  auto first = queue.push(make(OutputAct::answer, "a"));
  auto second = queue.push(make(OutputAct::question, "q"));
  EXPECT_NE(first, second);
  EXPECT_FALSE(queue.empty());
  auto result = queue.release(false);
  EXPECT_EQ(texts(result.released), (Texts{"a", "q"}));
  EXPECT_EQ(result.released[0].state, OutputState::playing);
  EXPECT_TRUE(result.withdrawn.empty());
  EXPECT_TRUE(queue.empty());
  EXPECT_FALSE(queue.has(first));
}

struct Fate {
  OutputAct act;
  bool withdrawn;
};

class OutputFate : public testing::TestWithParam<Fate> {};

TEST_P(OutputFate, WhenTheUserGoesOn) {
  OutputQueue queue;
  queue.push(make(GetParam().act, "x"));
  auto result = queue.release(true);
  EXPECT_EQ(result.withdrawn.size(), GetParam().withdrawn ? 1u : 0u);
  EXPECT_EQ(result.released.size(), GetParam().withdrawn ? 0u : 1u);
  EXPECT_TRUE(queue.empty());
}

INSTANTIATE_TEST_SUITE_P(All, OutputFate,
                         testing::Values(Fate{OutputAct::answer, false},
                                         Fate{OutputAct::chat, false},
                                         Fate{OutputAct::question, true},
                                         Fate{OutputAct::reprompt, true},
                                         Fate{OutputAct::resume, true}));

TEST(OutputQueue, WhatWaitsForWordsHoldsUpTheRest) {
  OutputQueue queue;
  auto id = queue.push(make(OutputAct::answer, "", OutputState::worded));
  queue.push(make(OutputAct::answer, "second"));
  EXPECT_TRUE(queue.release(false).released.empty());
  EXPECT_TRUE(queue.has(id));
  queue.word(id, "first");
  EXPECT_EQ(texts(queue.release(false).released), (Texts{"first", "second"}));
}

TEST(OutputQueue, AnAnswerIsGivenOnceInATurn) {
  OutputQueue queue;
  const auto answer = [](std::string text, script::TopicId topic,
                         std::uint64_t turn) {
    auto output = make(OutputAct::answer, std::move(text));
    output.topic = topic;
    output.turn = turn;
    return output;
  };
  for (const auto topic : {0U, 0U, 1U})
    queue.push(answer("over there", topic, 1));
  queue.push(answer("over there", script::no_id, 1)); // of a <speak>
  queue.push(answer("over there", 0, 2));
  queue.push(answer("somewhere else", 0, 1));
  EXPECT_EQ(texts(queue.release(false).released),
            (Texts{"over there", "over there", "somewhere else"}));
  queue.push(answer("over there", 0, 2));
  EXPECT_TRUE(queue.release(false).released.empty());
  EXPECT_TRUE(queue.empty());
  queue.turn_begins();
  queue.push(answer("over there", 0, 3));
  EXPECT_EQ(texts(queue.release(false).released), Texts{"over there"});
}

TEST(OutputQueue, NoWordsDropAnEntry) {
  OutputQueue queue;
  auto id = queue.push(make(OutputAct::answer, "", OutputState::worded));
  queue.word(id, "");
  EXPECT_FALSE(queue.has(id));
  EXPECT_TRUE(queue.empty());
  queue.word(id, "too late");
  EXPECT_TRUE(queue.empty());
}

TEST(OutputQueue, AQuestionWithoutWordsIsWithdrawnToo) {
  OutputQueue queue;
  queue.push(make(OutputAct::answer, "", OutputState::worded));
  auto question =
      queue.push(make(OutputAct::question, "", OutputState::worded));
  EXPECT_EQ(queue.release(true).withdrawn.size(), 1u);
  EXPECT_FALSE(queue.has(question));
  EXPECT_FALSE(queue.empty());
}

TEST(OutputQueue, QuestionsCanBeWithdrawnAtAnyTime) {
  OutputQueue queue;
  queue.push(make(OutputAct::answer, "a"));
  queue.push(make(OutputAct::question, "q"));
  auto withdrawn = queue.withdraw_questions();
  ASSERT_EQ(texts(withdrawn), (Texts{"q"}));
  EXPECT_EQ(withdrawn[0].state, OutputState::withdrawn);
  EXPECT_EQ(texts(queue.release(false).released), (Texts{"a"}));
}

TEST(OutputQueue, RemembersTheLastRobotTurn) {
  OutputQueue queue;
  queue.push(make(OutputAct::answer, "a"));
  queue.release(false);
  queue.push(make(OutputAct::question, "q"));
  queue.release(false);
  EXPECT_EQ(queue.last_turn(), (Texts{"a", "q"}));
  queue.turn_begins();
  EXPECT_EQ(queue.last_turn(), (Texts{"a", "q"}));
  queue.push(make(OutputAct::question, "withdrawn"));
  queue.release(true);
  EXPECT_EQ(queue.last_turn(), (Texts{"a", "q"}));
  queue.push(make(OutputAct::answer, "b"));
  queue.release(false);
  EXPECT_EQ(queue.last_turn(), (Texts{"b"}));
}

TEST(OutputQueue, OfWhatWasBrokenOffOnlyWhatWasHeardIsRemembered) {
  OutputQueue queue;
  const auto first = queue.push(make(OutputAct::answer, "two shops here"));
  const auto second = queue.push(make(OutputAct::question, "When?"));
  queue.release(false);
  ASSERT_TRUE(queue.cut(first, "two"));
  EXPECT_EQ(queue.cut(second, "")->text, "When?");
  EXPECT_FALSE(queue.cut(99, ""));
  EXPECT_EQ(queue.last_turn(), (Texts{"two"}));
}

} // namespace

} // namespace parlour::dialogue
