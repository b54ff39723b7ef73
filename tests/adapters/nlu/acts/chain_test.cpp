#include <gtest/gtest.h>

#include "adapters/nlu/acts/chain.hpp"

namespace parlour::adapters::nlu {
namespace {

Island island(std::uint32_t begin, std::uint32_t end, double score,
              std::vector<TopicNumber> topics, const std::string& slot = "") {
  Island made;
  made.begin = begin;
  made.end = end;
  made.score = score;
  made.topics = std::move(topics);
  if (!slot.empty())
    made.fills.push_back({slot, no_topic, {}, {}, begin, end});
  return made;
}

Island marker(std::uint32_t begin) {
  auto made = island(begin, begin + 1, 1, {});
  made.act = "deny";
  return made;
}

// "0-2:1 2-3:-" for the links of the best chain: begin, end, topic.
std::string best(const std::vector<Island>& islands, std::size_t size,
                 const Context& context = {}) {
  std::string text;
  const auto chains = best_chains(islands, size, context);
  for (const auto& link : chains.at(0).links)
    text += (text.empty() ? "" : " ") + std::to_string(link.island->begin) +
            "-" + std::to_string(link.island->end) + ":" +
            (link.topic == no_topic ? "-" : std::to_string(link.topic));
  return text;
}

TEST(Chain, OfNothingIsEmpty) {
  EXPECT_EQ(best({}, 0), "");
  EXPECT_EQ(best({}, 3), "");
}

TEST(Chain, GoesFromIslandToIslandWithoutOverlap) {
  EXPECT_EQ(
      best({island(0, 2, 2.1, {0}), island(1, 3, 2, {0}), island(3, 4, 1, {0})},
           5),
      "0-2:0 3-4:0");
}

TEST(Chain, PrefersOneLongIslandToTwo) {
  EXPECT_EQ(
      best({island(0, 1, 1, {0}), island(1, 2, 1, {0}), island(0, 2, 2, {0})},
           2),
      "0-2:0");
}

TEST(Chain, LeavesOutWhatIsNotWorthIt) {
  EXPECT_EQ(best({island(0, 1, 0.1, {0})}, 1), "");
}

TEST(Chain, StaysInATopicWhereItCan) {
  EXPECT_EQ(best({island(0, 1, 1, {1}), island(1, 2, 1, {0, 1})}, 2),
            "0-1:1 1-2:1");
}

TEST(Chain, FollowsTheContext) {
  Context context;
  context.current = 1;
  EXPECT_EQ(best({island(0, 1, 1, {0, 1})}, 1, context), "0-1:1");
  context.asked_topic = 0;
  context.asked_slot = "Time";
  EXPECT_EQ(best({island(0, 1, 1, {0, 1}, "Time")}, 1, context), "0-1:0");
}

TEST(Chain, WhatEndsAQuestionIsNoAnswerToTheAskedOne) {
  Context context;
  context.asked_topic = 0;
  context.asked_slot = "Time";
  const auto whole = island(0, 3, 2, {1});
  const auto question = island(0, 2, 1.6, {1});
  const auto now = island(2, 3, 0.7, {0}, "Time");
  EXPECT_EQ(best({whole, question, now}, 3, context), "0-3:1");
}

TEST(Chain, TakesAWeakIslandOnlyAfterACorrection) {
  auto four = island(1, 2, 1, {0});
  four.weak = true;
  EXPECT_EQ(best({four}, 2), "");
  EXPECT_EQ(best({marker(0), four}, 2), "0-1:- 1-2:0");
}

TEST(Chain, TakesAWeakIslandAfterALeadInWhereItIsExpected) {
  auto third = island(1, 2, 1, {0, 1});
  third.weak = true;
  auto and_what = marker(0);
  and_what.act = "";
  EXPECT_EQ(best({and_what, third}, 2), "0-1:-");
  Context context;
  context.resting = 1;
  EXPECT_EQ(best({and_what, third}, 2, context), "0-1:- 1-2:1");
}

TEST(Chain, TakesAWeakIslandThatEndsWhatIsSaidBehindAnAnswer) {
  const auto room = island(0, 1, 1, {0}, "Room");
  auto degrees = island(1, 2, 0.7, {0}, "Degrees");
  degrees.weak = true;
  Context context;
  context.asked_topic = 0;
  context.asked_slot = "Room";
  EXPECT_EQ(best({room, degrees}, 2, context), "0-1:0 1-2:0");
  EXPECT_EQ(best({room, degrees}, 2), "0-1:0");
  EXPECT_EQ(best({room, degrees}, 3, context), "0-1:0"); // something follows
  context.asked_slot = "Floor";
  EXPECT_EQ(best({room, degrees}, 2, context), "0-1:0"); // no answer
}

TEST(Chain, DoesNotSayASlotTwiceUnlessItIsCorrected) {
  const auto three = island(0, 1, 1, {0}, "Time");
  const auto four = island(2, 3, 0.5, {0}, "Time");
  EXPECT_EQ(best({three, four}, 3), "0-1:0");
  EXPECT_EQ(best({three, marker(1), four}, 3), "0-1:0 1-2:0 2-3:0");
}

TEST(Chain, ThereIsOneForEachTopicBestFirst) {
  const std::vector<Island> islands{island(0, 1, 1, {0}),
                                    island(0, 1, 1.2, {1})};
  const auto chains = best_chains(islands, 1, {});
  ASSERT_EQ(chains.size(), 3U); // the third says nothing
  EXPECT_EQ(chains[0].links.at(0).topic, 1U);
  EXPECT_EQ(chains[1].links.at(0).topic, 0U);
  EXPECT_TRUE(chains[2].links.empty());
  EXPECT_GT(chains[0].score, chains[1].score);
}

TEST(Chain, TellsHowMuchItCovers) {
  const Automaton automaton;
  const auto utterance = make_utterance("zork bank", automaton);
  auto zork = island(0, 1, 1, {0});
  zork.covered = utterance.weight_of(0, 1);
  const Chain chain{{{&zork, 0}}, 1};
  EXPECT_DOUBLE_EQ(chain.coverage(utterance), 0.5);
  EXPECT_DOUBLE_EQ(Chain().coverage(utterance), 0);
  EXPECT_DOUBLE_EQ(chain.coverage(make_utterance("", automaton)), 0);
}

} // namespace
} // namespace parlour::adapters::nlu
