#include <gtest/gtest.h>

#include "adapters/nlu/understand/alternatives.hpp"

namespace parlour::adapters::nlu::test {
namespace {

BuiltAct act(TopicNumber topic, double score, std::uint32_t begin = 0) {
  BuiltAct made;
  made.act = "inform";
  made.topic = topic;
  made.score = score;
  made.fills = {{"Time", topic, {}, {}, begin, begin + 1}};
  return made;
}

std::size_t added(const BuiltAct& best, std::vector<BuiltAct> acts) {
  Alternatives alternatives;
  add_alternative(alternatives, best, std::move(acts));
  return alternatives.acts.size();
}

TEST(Alternatives, AreOneActOfAnotherTopicThatScoresNearly) {
  EXPECT_EQ(added(act(0, 0.8), {act(1, 0.75)}), 1U);
  EXPECT_EQ(added(act(0, 0.8), {act(1, 0.7)}), 0U);
  EXPECT_EQ(added(act(0, 0.8), {act(1, 0.6)}), 0U);
  EXPECT_EQ(added(act(0, 0.8), {act(0, 0.8)}), 0U);
  EXPECT_EQ(added(act(0, 0.8), {act(1, 0.8), act(2, 0.8)}), 0U);
  EXPECT_EQ(added(act(0, 0.8), {}), 0U);
  EXPECT_EQ(added(act(0, 0.8), {act(no_topic, 0.8)}), 0U);
}

TEST(Alternatives, MaySayTheSame) {
  Alternatives alternatives;
  add_alternative(alternatives, act(0, 0.8), {act(1, 0.8, 4)});
  EXPECT_FALSE(alternatives.same_slots);
  add_alternative(alternatives, act(0, 0.8), {act(1, 0.8)});
  EXPECT_TRUE(alternatives.same_slots);
}

} // namespace
} // namespace parlour::adapters::nlu::test
