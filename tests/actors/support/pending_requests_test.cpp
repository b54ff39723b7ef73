#include <gtest/gtest.h>

#include "actors/support/pending_requests.hpp"

namespace parlour::actors {
namespace {

Message message(const char* command, Correlation correlation,
                const char* session = "s1") {
  Message made;
  made.command = command;
  made.session = session;
  made.correlation = correlation;
  return made;
}

TEST(PendingRequests, IsEndedByAReplyOnly) {
  PendingRequests unanswered({"Telephone"});
  unanswered.given(message("Call", 7), 0);
  unanswered.said(message("Ringing", 7));
  unanswered.said(message("Answered", 8));
  unanswered.said(message("Answered", 7, "s2"));
  unanswered.said(message("Answered", 0));
  EXPECT_FALSE(unanswered.none(0));
  unanswered.said(message("Answered", 7));
  EXPECT_TRUE(unanswered.none(0));
}

TEST(PendingRequests, TakesAnEventOfItsOwnForAnAnswer) {
  PendingRequests unanswered({"Oven"});
  unanswered.given(message("Bake", 7), 0);
  unanswered.said(message("Baked", 7));
  EXPECT_TRUE(unanswered.none(0));
}

TEST(PendingRequests, IsNotEndedByAnEventThatIsDescribedAsNone) {
  PendingRequests unanswered({"Oven"}, {{"Warm", "degrees", Reply::none}});
  unanswered.given(message("Bake", 7), 0);
  unanswered.said(message("Warm", 7));
  EXPECT_FALSE(unanswered.none(0));
}

TEST(PendingRequests, KeepsNothingThatWaitsForNoAnswer) {
  PendingRequests unanswered({"TTS"});
  unanswered.given(message("Speak", 0), 0);
  unanswered.given(message("Stop", 7), 0);
  EXPECT_TRUE(unanswered.none(0));
}

TEST(PendingRequests, TellsWhomToAnswerOnce) {
  PendingRequests unanswered({"Taxi"});
  unanswered.given(message("Book", 7), 0);
  unanswered.given(message("Book", 7, "s2"), 0);
  const auto left = unanswered.take(1);
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[1].session, "s2");
  EXPECT_EQ(left[1].correlation, 7u);
  EXPECT_TRUE(unanswered.take(1).empty());
}

TEST(PendingRequests, IsBounded) {
  PendingRequests unanswered({"Taxi"});
  for (Correlation i = 1; i <= PendingRequests::max_entries + 5; ++i)
    unanswered.given(message("Book", i), 0);
  EXPECT_FALSE(unanswered.none(PendingRequests::patience.count() - 1));
  const auto left = unanswered.take(1);
  EXPECT_EQ(left.size(), PendingRequests::max_entries);
  EXPECT_EQ(left.front().correlation, 6u);
  unanswered.given(message("Book", 1), 0);
  EXPECT_TRUE(unanswered.none(PendingRequests::patience.count()));
}

} // namespace
} // namespace parlour::actors
