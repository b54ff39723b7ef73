#include <algorithm>
#include <set>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/components/instance_life.hpp"

namespace parlour::actors {
namespace {

using State = InstanceState;
using Event = InstanceEvent;
using Deed = InstanceDeed;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr auto first_state = State::starting;
constexpr auto last_state = State::gone;
constexpr auto last_event = Event::stopped;

std::vector<State> states() {
  std::vector<State> all;
  for (int i = 0; i <= static_cast<int>(last_state); ++i)
    all.push_back(static_cast<State>(i));
  return all;
}

std::vector<Event> events() {
  std::vector<Event> all;
  for (int i = 0; i <= static_cast<int>(last_event); ++i)
    all.push_back(static_cast<Event>(i));
  return all;
}

std::vector<Deed> deeds(State state, Event event) {
  const auto& row = transition(state, event);
  return {row.deeds.begin(), row.deeds.end()};
}

// Where it ends by these events, and nothing impossible is among them.
State after(std::vector<Event> story) {
  auto state = first_state;
  for (auto event : story) {
    const auto& row = transition(state, event);
    EXPECT_TRUE(row.next) << name_of(state) << ", " << name_of(event);
    state = row.next.value_or(State::gone);
  }
  return state;
}

TEST(InstanceLife, IsLookedUpByStateAndEvent) {
  for (auto state : states())
    for (auto event : events()) {
      EXPECT_EQ(transition(state, event).state, state);
      EXPECT_EQ(transition(state, event).event, event);
    }
}

TEST(InstanceLife, WhatIsImpossibleHasNoDeeds) {
  for (auto state : states())
    for (auto event : events())
      if (!transition(state, event).next) {
        EXPECT_THAT(deeds(state, event), IsEmpty())
            << name_of(state) << ", " << name_of(event);
      }
}

TEST(InstanceLife, OfOneThatServesAndLeaves) {
  EXPECT_EQ(after({Event::started}), State::working);
  EXPECT_EQ(after({Event::started, Event::drain}), State::draining);
  EXPECT_EQ(after({Event::started, Event::drain, Event::finished}),
            State::stopping);
  EXPECT_EQ(
      after({Event::started, Event::drain, Event::finished, Event::stopped}),
      State::gone);
}

TEST(InstanceLife, OfOneThatNobodyWantsBeforeItHasStarted) {
  EXPECT_EQ(after({Event::drain, Event::started}), State::stopping);
  EXPECT_EQ(after({Event::drain, Event::not_started}), State::stopping);
  EXPECT_EQ(after({Event::stop, Event::started}), State::stopping);
}

TEST(InstanceLife, AnotherFailureOfOneThatStopsIsNotCounted) {
  EXPECT_THAT(
      deeds(State::working, Event::failed),
      ElementsAre(Deed::stop_plugin, Deed::answer_failure, Deed::blame));
  EXPECT_EQ(after({Event::started, Event::failed, Event::failed}),
            State::stopping);
  EXPECT_THAT(deeds(State::stopping, Event::failed), IsEmpty());
}

TEST(InstanceLife, ACallThatDoesNotReturnEndsIt) {
  for (auto state : states())
    EXPECT_EQ(transition(state, Event::hung).next, State::gone);
}

TEST(InstanceLife, NothingBringsBackOneThatIsGone) {
  for (auto event : events()) {
    EXPECT_EQ(transition(State::gone, event).next, State::gone);
    EXPECT_THAT(deeds(State::gone, event), IsEmpty());
  }
}

// Who waits for an answer is told before the instance is forgotten, and it is
// forgotten exactly where it goes.
TEST(InstanceLife, WhatIsOwedIsAnsweredBeforeItGoes) {
  for (auto state : states())
    for (auto event : events()) {
      const auto all = deeds(state, event);
      const bool goes = transition(state, event).next == State::gone;
      const auto answers = std::ranges::find(all, Deed::answer_failure);
      const auto removes = std::ranges::find(all, Deed::remove);
      if (state == State::gone)
        continue;
      EXPECT_EQ(goes, removes != all.end()) << name_of(event);
      EXPECT_TRUE(!goes || answers < removes) << name_of(event);
    }
}

TEST(InstanceLife, EachStateIsReachedAndLeadsToTheEnd) {
  std::set<State> reached = {first_state};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (auto state : std::set(reached))
      for (auto event : events())
        if (auto next = transition(state, event).next)
          reached.insert(*next);
  }
  EXPECT_EQ(reached.size(), states().size());
  for (auto state : states())
    EXPECT_EQ(transition(state, Event::hung).next, State::gone);
}

TEST(InstanceLife, StatesAndEventsHaveTheirNames) {
  EXPECT_EQ(name_of(State::starting), "starting");
  EXPECT_EQ(name_of(State::gone), "gone");
  EXPECT_EQ(name_of(Event::not_started), "not_started");
}

} // namespace
} // namespace parlour::actors
