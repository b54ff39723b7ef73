#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/components/life_events.hpp"

namespace parlour::actors {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr InstanceId first = 1;
constexpr InstanceId second = 2;

// Writes down what is to be done, and what a test says happens then.
class LifeEventsTest : public testing::Test {
protected:
  LifeEventsTest() {
    service->component = std::make_shared<Component>();
    service->component->order.name = "City";
    events.begin(first);
  }

  template <class Who, class Event>
  void happens(const Who& who, Event event, const Cause& cause = {}) {
    events.happens(who, event, cause);
    while (const auto made = events.next())
      std::visit([this](const auto& one) { this->take(one); }, *made);
  }

  void take(const InstanceDeeds& what) {
    done.push_back(fmt::format("instance {} is {}", what.id,
                               name_of(events.state_of(what.id))));
    for (auto deed : what.deeds)
      if (on_deed)
        on_deed(deed, what.id);
  }
  void take(const ServiceDeeds& what) {
    done.push_back(fmt::format("City {}", what.cause.error.message));
    for (auto deed : what.deeds)
      if (on_service_deed)
        on_service_deed(deed);
  }
  void take(const Impossible& what) {
    done.push_back(what.text);
  }

  ServicePointer service = std::make_shared<Service>();
  LifeEvents events;
  std::function<void(InstanceDeed, InstanceId)> on_deed;
  std::function<void(ServiceDeed)> on_service_deed;
  std::vector<std::string> done;
};

TEST_F(LifeEventsTest, AnInstanceGoesThroughItsStates) {
  EXPECT_EQ(events.state_of(first), InstanceState::starting);
  happens(first, InstanceEvent::started);
  EXPECT_EQ(events.state_of(first), InstanceState::working);
  happens(first, InstanceEvent::hung);
  EXPECT_EQ(events.state_of(first), InstanceState::gone);
  EXPECT_EQ(events.state_of(second), InstanceState::gone); // has not begun
}

TEST_F(LifeEventsTest, NothingFollowsForOneThatIsGone) {
  happens(second, InstanceEvent::started);
  EXPECT_THAT(done, IsEmpty());
}

TEST_F(LifeEventsTest, DeedsAreGivenTheCause) {
  happens(service, ServiceEvent::leave);
  happens(service, ServiceEvent::failed, {{ErrorKind::settings, "crash", {}}});
  EXPECT_THAT(done, ElementsAre("City ", "City crash"));
}

// The second deed would otherwise be one of a state that is over.
TEST_F(LifeEventsTest, ATransitionIsOverBeforeWhatItLeadsTo) {
  on_deed = [&](InstanceDeed deed, InstanceId id) {
    if (deed == InstanceDeed::watch_calls)
      events.happens(id, InstanceEvent::stop);
  };
  happens(first, InstanceEvent::started); // watch_calls, enlist
  EXPECT_THAT(done,
              ElementsAre("instance 1 is working", "instance 1 is stopping"));
}

// A service hears of the pause before it hears that there is room for another
// instance.
TEST_F(LifeEventsTest, WhatFollowsFromAnEventComesBeforeTheNext) {
  service->state = ServiceState::serving;
  on_deed = [&](InstanceDeed deed, InstanceId) {
    if (deed == InstanceDeed::blame)
      events.happens(service, ServiceEvent::failed);
    if (deed == InstanceDeed::remove)
      events.happens(service, ServiceEvent::instance_gone);
  };
  std::vector<ServiceDeed> deeds;
  on_service_deed = [&](ServiceDeed deed) {
    deeds.push_back(deed);
    if (deed == ServiceDeed::count_failure)
      events.happens(service, ServiceEvent::to_retry);
  };
  happens(first, InstanceEvent::hung);
  EXPECT_THAT(
      deeds, ElementsAre(ServiceDeed::count_failure, ServiceDeed::retry_later));
  EXPECT_EQ(service->state, ServiceState::backing_off);
}

TEST_F(LifeEventsTest, WhatIsImpossibleIsToldAndChangesNothing) {
  happens(first, InstanceEvent::stopped);
  happens(service, ServiceEvent::retry);
  EXPECT_THAT(
      done,
      ElementsAre("instance 1: 'stopped' cannot happen in state 'starting'",
                  "City: 'retry' cannot happen in state 'coming'"));
  EXPECT_EQ(events.state_of(first), InstanceState::starting);
  EXPECT_EQ(service->state, ServiceState::coming);
}

} // namespace
} // namespace parlour::actors
