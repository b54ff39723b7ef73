#include <utility>

#include <gtest/gtest.h>

#include "actors/protocol/due_times.hpp"

namespace parlour::actors {
namespace {

using Of = DueTimes::Of;

TEST(DueTimes, KnowsTheEarliest) {
  DueTimes times([] {});
  EXPECT_FALSE(times.next());
  times.add(30, Of::session);
  auto early = times.add(10, Of::session);
  times.add(10, Of::component);
  EXPECT_EQ(times.next()->id, early);
  EXPECT_EQ(times.next()->due, 10);
  EXPECT_FALSE(times.overdue(9));
  EXPECT_TRUE(times.overdue(10));
}

TEST(DueTimes, KnowsTheEarliestOfSessions) {
  DueTimes times([] {});
  EXPECT_FALSE(times.next_of_sessions());
  times.add(5, Of::component);
  EXPECT_FALSE(times.next_of_sessions());
  times.add(30, Of::session);
  times.add(20, Of::session);
  EXPECT_EQ(times.next_of_sessions(), 20);
}

// As many as a busy node has; a search through all would take minutes.
TEST(DueTimes, GivesManyInOrder) {
  constexpr int many = 100'000;
  DueTimes times([] {});
  for (int i = 0; i < many; ++i)
    times.add(i * 7'919 % many, i % 2 == 0 ? Of::session : Of::component);
  for (Timestamp due = 0; due < many; ++due) {
    const auto next = times.next();
    ASSERT_TRUE(next);
    ASSERT_EQ(next->due, due);
    ASSERT_TRUE(times.overdue(due));
    times.remove(next->id);
  }
  EXPECT_FALSE(times.next());
  EXPECT_FALSE(times.next_of_sessions());
  EXPECT_FALSE(times.component_pending());
}

TEST(DueTimes, TellsOfEachRemovalOnce) {
  int changes = 0;
  DueTimes times([&] { ++changes; });
  auto id = times.add(10, Of::component);
  EXPECT_TRUE(times.has(id));
  EXPECT_TRUE(times.component_pending());
  times.remove(id);
  times.remove(id);
  EXPECT_FALSE(times.has(id));
  EXPECT_FALSE(times.component_pending());
  EXPECT_EQ(changes, 1);
}

TEST(DueTicket, RemovesItsEntryWhenItGoes) {
  DueTimes times([] {});
  {
    DueTicket outer;
    {
      DueTicket inner(times, times.add(10, Of::session));
      outer = std::move(inner);
    }
    EXPECT_TRUE(times.next());
  }
  EXPECT_FALSE(times.next());
}

} // namespace
} // namespace parlour::actors
