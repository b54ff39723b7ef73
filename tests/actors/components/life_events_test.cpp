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

// Writes down what is done, and does what a test says.
class LifeEventsTest : public testing::Test, private LifeDeeds {
protected:
  LifeEventsTest() {
    service->component = std::make_shared<Component>();
    service->component->order.name = "City";
    events.begin(first);
  }

  void carry_out(InstanceDeed deed, InstanceId id, const Cause&) override {
    done.push_back(fmt::format("deed of {}", id));
    if (on_deed)
      on_deed(deed, id);
    done.push_back("done");
  }
  void carry_out(ServiceDeed deed, const ServicePointer&,
                 const Cause& cause) override {
    done.push_back(fmt::format("deed of City {}", cause.error.message));
    if (on_service_deed)
      on_service_deed(deed);
  }
  void log_error(const std::string& text) override {
    done.push_back(text);
  }

  ServicePointer service = std::make_shared<Service>();
  LifeEvents events{*this};
  std::function<void(InstanceDeed, InstanceId)> on_deed;
  std::function<void(ServiceDeed)> on_service_deed;
  std::vector<std::string> done;
};

TEST_F(LifeEventsTest, AnInstanceGoesThroughItsStates) {
  EXPECT_EQ(events.state_of(first), InstanceState::starting);
  events.happens(first, InstanceEvent::started);
  EXPECT_EQ(events.state_of(first), InstanceState::working);
  events.happens(first, InstanceEvent::hung);
  EXPECT_EQ(events.state_of(first), InstanceState::gone);
  EXPECT_EQ(events.state_of(second), InstanceState::gone); // has not begun
}

TEST_F(LifeEventsTest, NothingFollowsForOneThatIsGone) {
  events.happens(second, InstanceEvent::started);
  EXPECT_THAT(done, IsEmpty());
}

TEST_F(LifeEventsTest, DeedsAreGivenTheCause) {
  events.happens(service, ServiceEvent::leave);
  events.happens(service, ServiceEvent::failed,
                 {{ErrorKind::settings, "crash", {}}});
  EXPECT_THAT(done, ElementsAre("deed of City crash"));
}

// The second deed would otherwise be one of a state that is over.
TEST_F(LifeEventsTest, ATransitionIsOverBeforeWhatItLeadsTo) {
  on_deed = [&](InstanceDeed deed, InstanceId id) {
    if (deed == InstanceDeed::watch_calls)
      events.happens(id, InstanceEvent::stop);
  };
  events.happens(first, InstanceEvent::started); // watch_calls, enlist
  EXPECT_THAT(done, ElementsAre("deed of 1", "done", "deed of 1", "done",
                                "deed of 1", "done"));
  EXPECT_EQ(events.state_of(first), InstanceState::stopping);
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
  events.happens(first, InstanceEvent::hung);
  EXPECT_THAT(
      deeds, ElementsAre(ServiceDeed::count_failure, ServiceDeed::retry_later));
  EXPECT_EQ(service->state, ServiceState::backing_off);
}

TEST_F(LifeEventsTest, ReportsAreMadeWhenNoEventIsLeft) {
  on_deed = [&](InstanceDeed deed, InstanceId id) {
    if (deed != InstanceDeed::watch_calls)
      return;
    events.report([&, id] {
      EXPECT_EQ(events.state_of(id), InstanceState::stopping);
      events.happens(second, InstanceEvent::drain);
      EXPECT_EQ(events.state_of(second), InstanceState::draining);
    });
    events.happens(id, InstanceEvent::stop);
  };
  events.begin(second);
  events.happens(first, InstanceEvent::started);
  EXPECT_EQ(events.state_of(second), InstanceState::draining);
}

TEST_F(LifeEventsTest, AReportIsOverBeforeTheNext) {
  std::vector<std::string> told;
  on_deed = [&](InstanceDeed, InstanceId id) {
    events.report([&, id] {
      told.push_back(fmt::format("begins {}", id));
      if (id == first)
        events.happens(second, InstanceEvent::drain);
      told.push_back(fmt::format("ends {}", id));
    });
  };
  events.begin(second);
  events.happens(first, InstanceEvent::drain);
  EXPECT_THAT(told, ElementsAre("begins 1", "ends 1", "begins 2", "ends 2"));
}

// Debug builds end there.
TEST_F(LifeEventsTest, WhatIsImpossibleIsLoggedAndChangesNothing) {
#ifdef NDEBUG
  events.happens(first, InstanceEvent::stopped);
  events.happens(service, ServiceEvent::retry);
  EXPECT_THAT(
      done,
      ElementsAre("instance 1: 'stopped' cannot happen in state 'starting'",
                  "City: 'retry' cannot happen in state 'coming'"));
  EXPECT_EQ(events.state_of(first), InstanceState::starting);
  EXPECT_EQ(service->state, ServiceState::coming);
#else
  EXPECT_DEATH(events.happens(first, InstanceEvent::stopped),
               "the table of its life");
#endif
}

} // namespace
} // namespace parlour::actors
