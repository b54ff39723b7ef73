#include <gtest/gtest.h>

#include "script/dialogue/inputs/session_history.hpp"

namespace parlour::dialogue {
namespace {

const SessionRecord opened{"s", SessionOpened{7, 8, true}};
const SessionRecord input{"s", InputTaken{"input", "answers"}};

SessionRecord state(std::uint64_t inputs) {
  return {"s", StateKept{{7, 8, true}, inputs, "state", {}}};
}

class SessionHistoryTest : public testing::Test {
protected:
  SessionHistory history;

  bool take(const SessionRecord& record,
            HistoryFrom from = HistoryFrom::last_state) {
    return dialogue::take(history, record, from);
  }
};

TEST_F(SessionHistoryTest, IsWhatTheRecordsSay) {
  EXPECT_TRUE(take(opened));
  EXPECT_TRUE(take(input));
  EXPECT_TRUE(take({"s", EffectsDone{1}}));
  EXPECT_EQ(history.id, "s");
  EXPECT_EQ(history.opened.seed, 8u);
  EXPECT_EQ(history.inputs.size(), 1u);
  EXPECT_EQ(history.posted, 1u);
  EXPECT_FALSE(history.closed);
  EXPECT_TRUE(take({"s", SessionClosed{}}));
  EXPECT_TRUE(history.closed);
}

TEST_F(SessionHistoryTest, BeginsAtTheLastState) {
  take(opened);
  take(input);
  EXPECT_TRUE(take(state(1)));
  take(input);
  EXPECT_EQ(history.before, 1u);
  EXPECT_EQ(history.state, "state");
  EXPECT_EQ(history.count(), 2u);
}

TEST_F(SessionHistoryTest, BeginsWithTheSessionWhereNothingIsMissing) {
  take(opened, HistoryFrom::beginning);
  take(input, HistoryFrom::beginning);
  EXPECT_TRUE(take(state(1), HistoryFrom::beginning));
  EXPECT_EQ(history.before, 0u);
  // Behind a gap it cannot.
  EXPECT_TRUE(take(state(3), HistoryFrom::beginning));
  EXPECT_EQ(history.before, 3u);
  EXPECT_TRUE(history.inputs.empty());
}

// What came before was held with other scripts.
TEST_F(SessionHistoryTest, BeginsAtAChangeOfTheProgram) {
  take(opened, HistoryFrom::beginning);
  take(input, HistoryFrom::beginning);
  EXPECT_TRUE(take({"s", StateKept{{9, 8, true}, 1, "other", {}}},
                   HistoryFrom::beginning));
  EXPECT_EQ(history.opened.program, 9u);
  EXPECT_EQ(history.before, 1u);
  EXPECT_TRUE(history.inputs.empty());
}

TEST_F(SessionHistoryTest, WhatFollowsNothingIsNoHistory) {
  EXPECT_FALSE(take(input));
  EXPECT_FALSE(SessionHistoryTest::take({"s", EffectsDone{1}}) &&
               history.inputs.empty());
  history = {};
  EXPECT_TRUE(take(state(5)));
}

} // namespace
} // namespace parlour::dialogue
