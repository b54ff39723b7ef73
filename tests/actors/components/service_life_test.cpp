#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/components/service_life.hpp"

namespace parlour::actors {
namespace {

using State = ServiceState;
using Event = ServiceEvent;
using Deed = ServiceDeed;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<State> states() {
  return {State::coming, State::serving, State::backing_off, State::down,
          State::leaving};
}

std::vector<Event> events() {
  std::vector<Event> all;
  for (int i = 0; i <= static_cast<int>(Event::leave); ++i)
    all.push_back(static_cast<Event>(i));
  return all;
}

std::vector<Deed> deeds(State state, Event event) {
  const auto& row = transition(state, event);
  return {row.deeds.begin(), row.deeds.end()};
}

State after(std::vector<Event> story) {
  auto state = State::coming;
  for (auto event : story) {
    const auto& row = transition(state, event);
    EXPECT_TRUE(row.next) << name_of(state) << ", " << name_of(event);
    state = row.next.value_or(State::leaving);
  }
  return state;
}

TEST(ServiceLife, IsLookedUpByStateAndEvent) {
  for (auto state : states())
    for (auto event : events()) {
      EXPECT_EQ(transition(state, event).state, state);
      EXPECT_EQ(transition(state, event).event, event);
      if (!transition(state, event).next) {
        EXPECT_THAT(deeds(state, event), IsEmpty());
      }
    }
}

TEST(ServiceLife, BacksOffAfterAFailureAndServesAgain) {
  EXPECT_EQ(after({Event::takes_over, Event::failed, Event::to_retry}),
            State::backing_off);
  EXPECT_EQ(after({Event::takes_over, Event::failed, Event::to_retry,
                   Event::retry, Event::worker_started}),
            State::serving);
}

// Of several instances, others may fail or start while it backs off.
TEST(ServiceLife, OthersGoOnWhileItBacksOff) {
  EXPECT_THAT(deeds(State::backing_off, Event::worker_started),
              ElementsAre(Deed::add_worker));
  EXPECT_EQ(after({Event::takes_over, Event::failed, Event::to_retry,
                   Event::failed, Event::exhausted}),
            State::down);
}

TEST(ServiceLife, MakesNoInstanceBeforeItsPauseIsOver) {
  for (auto state : {State::backing_off, State::down})
    for (auto event : events()) {
      const auto all = deeds(state, event);
      EXPECT_EQ(testing::Value(all, testing::Contains(Deed::fill_up)),
                event == Event::retry)
          << name_of(state) << ", " << name_of(event);
    }
}

TEST(ServiceLife, OneThatDoesNotStartIsTakenBackAndNotTriedAgain) {
  EXPECT_THAT(deeds(State::coming, Event::failed),
              ElementsAre(Deed::fail_activation));
  EXPECT_EQ(after({Event::failed}), State::leaving);
}

TEST(ServiceLife, NothingBringsBackOneThatLeaves) {
  for (auto event : events())
    EXPECT_EQ(transition(State::leaving, event).next.value_or(State::leaving),
              State::leaving)
        << name_of(event);
  for (auto state : states())
    EXPECT_EQ(transition(state, Event::leave).next, State::leaving);
}

TEST(ServiceLife, StatesAndEventsHaveTheirNames) {
  EXPECT_EQ(name_of(State::backing_off), "backing_off");
  EXPECT_EQ(name_of(Event::leave), "leave");
}

} // namespace
} // namespace parlour::actors
