#include <string>

#include <gtest/gtest.h>

#include "actors/sessions/held_effects.hpp"

namespace parlour::actors {
namespace {

class HeldEffectsTest : public testing::Test {
protected:
  HeldEffects effects{true};
  std::string done;

  void want(char what, HeldEffects::Noted noted = HeldEffects::Noted::no) {
    effects.perform([this, what] { done += what; }, {}, noted);
  }
};

TEST_F(HeldEffectsTest, AreDoneWhenTheirRecordIsWritten) {
  want('a');
  want('b');
  EXPECT_TRUE(effects.wait_for(5, 1));
  want('c');
  EXPECT_TRUE(effects.wait_for(7, 2));
  EXPECT_EQ(done, "");
  effects.written(4);
  EXPECT_EQ(done, "");
  effects.written(6);
  EXPECT_EQ(done, "ab");
  effects.written(7);
  EXPECT_EQ(done, "abc");
  EXPECT_TRUE(effects.none());
}

TEST_F(HeldEffectsTest, WaitForNothingWhereThereIsNone) {
  EXPECT_FALSE(effects.wait_for(1, 1));
  want('a');
  EXPECT_TRUE(effects.wait_for(2, 2));
  EXPECT_FALSE(effects.wait_for(3, 3));
}

TEST_F(HeldEffectsTest, TellsTheLastInputThatMustBeNoted) {
  want('a', HeldEffects::Noted::yes);
  effects.wait_for(1, 10);
  want('b', HeldEffects::Noted::yes);
  effects.wait_for(2, 11);
  want('c');
  effects.wait_for(3, 12);
  EXPECT_EQ(effects.written(3), 11u);
  EXPECT_EQ(effects.written(3), std::nullopt);
}

// What an effect leads to has no record yet.
TEST_F(HeldEffectsTest, AnEffectMayWantAnother) {
  effects.perform([this] { want('b'); });
  effects.wait_for(1, 1);
  effects.written(9);
  EXPECT_EQ(done, "");
  EXPECT_TRUE(effects.wait_for(10, 1));
  effects.written(10);
  EXPECT_EQ(done, "b");
}

TEST_F(HeldEffectsTest, WithoutAStrictJournalAllIsDoneAtOnce) {
  HeldEffects at_once(false);
  at_once.perform([this] { done += 'a'; });
  EXPECT_EQ(done, "a");
  EXPECT_TRUE(at_once.none());
}

} // namespace
} // namespace parlour::actors
