#include <gtest/gtest.h>

#include "runtime/base/defaults.hpp"
#include "script/dialogue/context/inbox.hpp"

namespace parlour::dialogue {
namespace {

struct InboxTest : testing::Test {
  static Input input(const char* command, TurnId turn = 0, bool said = false) {
    Message message;
    message.number = ++last;
    message.command = command;
    return {.message = std::make_shared<const Message>(std::move(message)),
            .turn = turn,
            .begins_turn = said};
  }
  std::string next(Inbox::Of whom = Inbox::Of::all) {
    const auto input = inbox.take_message(whom);
    return input ? input->message->command : "nothing";
  }
  // As many as are allowed without an external event.
  void count_to_the_limit() {
    for (int i = 0; i < defaults::internal_events; ++i)
      EXPECT_EQ(inbox.count_internal(), Inbox::Count::within);
  }

  static inline std::uint64_t last = 0;
  Turns turns;
  Inbox inbox{turns};
};

TEST_F(InboxTest, MessagesComeInTheOrderOfTheirArrival) {
  inbox.receive(input("one"));
  inbox.receive(input("two"));
  EXPECT_EQ(inbox.take_received(), last);
  EXPECT_FALSE(inbox.take_received()); // none since
  EXPECT_EQ(next(), "one");
  EXPECT_EQ(next(), "two");
  EXPECT_EQ(next(), "nothing");
}

TEST_F(InboxTest, WhatIsPutBackIsTheNext) {
  inbox.receive(input("two"));
  inbox.put_back(input("one"));
  EXPECT_EQ(next(), "one");
}

TEST_F(InboxTest, WhatTheUserSaysMayStay) {
  using enum Inbox::Of;
  inbox.receive(input("said", 0, true));
  EXPECT_TRUE(inbox.has_message(all));
  EXPECT_FALSE(inbox.has_message(all_but_user));
  inbox.receive(input("other"));
  EXPECT_EQ(next(all_but_user), "other");
  EXPECT_EQ(next(all_but_user), "nothing");
  EXPECT_EQ(inbox.take_unread().size(), 1u);
  EXPECT_FALSE(inbox.has_message(all));
}

TEST_F(InboxTest, HoldsTheTurnsOfWhatIsInIt) {
  const auto turn = turns.begin();
  inbox.receive(input("said", turn, true));
  inbox.add_internal(input("Raised", turn));
  turns.let_go(turn);
  EXPECT_TRUE(turns.any_open(0));
  turns.let_go(turn);
  EXPECT_FALSE(turns.any_open(0));
}

TEST_F(InboxTest, KnowsAnAnswerThatHasComeAlready) {
  Message message;
  message.correlation = 7;
  EXPECT_FALSE(inbox.has_answer_to(7));
  inbox.add_internal(
      {.message = std::make_shared<const Message>(std::move(message))});
  EXPECT_TRUE(inbox.has_answer_to(7));
}

TEST_F(InboxTest, BeyondTheLimitWhatIsQueuedIsDropped) {
  const auto turn = turns.begin();
  inbox.add_internal(input("Again", turn));
  count_to_the_limit();
  EXPECT_TRUE(turns.any_open(0));
  EXPECT_FALSE(inbox.has_dropped());
  EXPECT_EQ(inbox.count_internal(), Inbox::Count::just_above);
  EXPECT_FALSE(inbox.has_internal());
  EXPECT_FALSE(turns.any_open(0));
  const auto dropped = inbox.take_dropped();
  ASSERT_EQ(dropped.size(), 1u);
  EXPECT_EQ(dropped.front().message->command, "Again");
  EXPECT_FALSE(inbox.has_dropped());
}

// Who hears of it may raise events, too, but is not told again.
TEST_F(InboxTest, ItIsToldOnceBetweenTwoExternalEvents) {
  count_to_the_limit();
  EXPECT_EQ(inbox.count_internal(), Inbox::Count::just_above);
  count_to_the_limit();
  EXPECT_EQ(inbox.count_internal(), Inbox::Count::above);
  EXPECT_EQ(inbox.count_internal(), Inbox::Count::above);
  inbox.external_event_begins();
  count_to_the_limit();
  EXPECT_EQ(inbox.count_internal(), Inbox::Count::just_above);
}

TEST_F(InboxTest, RoundsBeginAnewOutside) {
  Message message;
  message.rounds = 3;
  inbox.handles(message);
  EXPECT_EQ(inbox.rounds(), 3u);
  inbox.external_event_begins();
  EXPECT_EQ(inbox.rounds(), 0u);
}

} // namespace
} // namespace parlour::dialogue
