#include "script/dialogue/topics/topic_order.hpp"
#include "tests/script/dialogue/dialogue_fixture.hpp"

namespace parlour::dialogue {

namespace {

using namespace std::chrono_literals;

class Order : public testing::Test {
protected:
  Receptionist app;
  TopicOrder order{app.program};
};

TEST_F(Order, NothingIsCurrentAtFirst) {
  EXPECT_FALSE(order.current());
  EXPECT_FALSE(order.next());
  EXPECT_TRUE(order.registered(app.taxi));
  EXPECT_FALSE(order.registered(script::no_id));
}

TEST_F(Order, AnotherTopicSuspendsAnUnfinishedTask) {
  EXPECT_FALSE(order.activate(app.appointment));
  EXPECT_TRUE(order.unfinished(app.appointment));
  EXPECT_EQ(order.activate(app.facility), app.appointment);
  EXPECT_EQ(order.current(), app.facility);
  EXPECT_EQ(order.suspended(), std::vector{app.appointment});
  EXPECT_TRUE(order.unfinished(app.appointment));
}

TEST_F(Order, TheSameTopicSuspendsNothing) {
  order.activate(app.appointment);
  EXPECT_FALSE(order.activate(app.appointment));
  EXPECT_TRUE(order.suspended().empty());
}

TEST_F(Order, TheLatestStaysWhenItIsNotCurrentAnyMore) {
  EXPECT_FALSE(order.latest());
  order.activate(app.appointment);
  order.activate(app.taxi);
  order.completed(app.taxi);
  EXPECT_FALSE(order.current());
  EXPECT_EQ(order.latest(), app.taxi);
}

TEST_F(Order, AnEnquiryIsNeverUnfinished) {
  order.activate(app.facility);
  EXPECT_FALSE(order.unfinished(app.facility));
  EXPECT_FALSE(order.activate(app.taxi));
  EXPECT_TRUE(order.suspended().empty());
}

TEST_F(Order, TheMostRecentlySuspendedResumesFirst) {
  order.activate(app.appointment);
  order.activate(app.taxi);
  order.activate(app.facility);
  order.answered(app.facility, 0);
  EXPECT_EQ(order.suspended(), (std::vector{app.taxi, app.appointment}));
  ASSERT_TRUE(order.next());
  EXPECT_EQ(order.next()->topic, app.taxi);
  EXPECT_TRUE(order.next()->resumes);
  order.activate(app.taxi);
  order.completed(app.taxi);
  EXPECT_FALSE(order.current());
  EXPECT_EQ(order.next()->topic, app.appointment);
  order.activate(app.appointment);
  order.completed(app.appointment);
  EXPECT_FALSE(order.next());
}

TEST_F(Order, ResumePolicyAndInitiativeDecideWhoComesBack) {
  app.program.topics[app.taxi].resume = script::ResumePolicy::never;
  order.activate(app.appointment);
  order.activate(app.taxi);
  order.activate(app.facility);
  EXPECT_EQ(order.next()->topic, app.appointment);
  app.program.topics[app.appointment].resume = script::ResumePolicy::ask;
  EXPECT_EQ(order.next()->topic, app.appointment);
  app.program.topics[app.appointment].initiative = script::Initiative::user;
  EXPECT_FALSE(order.next());
}

TEST_F(Order, ThenATopicOfSystemInitiativeStartsOnce) {
  app.program.topics[app.taxi].initiative = script::Initiative::system;
  ASSERT_TRUE(order.next());
  EXPECT_EQ(order.next()->topic, app.taxi);
  EXPECT_FALSE(order.next()->resumes);
  order.activate(app.taxi);
  order.completed(app.taxi);
  EXPECT_FALSE(order.next());
}

TEST_F(Order, ARestingEnquiryIsContextForAWhile) {
  EXPECT_FALSE(order.resting(0, 2min));
  order.activate(app.facility);
  order.answered(app.facility, 1000);
  EXPECT_FALSE(order.current());
  EXPECT_EQ(order.resting(1000, 2min), app.facility);
  EXPECT_EQ(order.resting(120'999, 2min), app.facility);
  EXPECT_FALSE(order.resting(121'000, 2min));
}

TEST_F(Order, AnotherAnsweredEnquiryTakesTheContextOver) {
  auto weather = app.topic("Weather", script::TopicKind::enquiry);
  TopicOrder both(app.program);
  both.activate(app.facility);
  both.answered(app.facility, 0);
  both.activate(weather);
  EXPECT_EQ(both.resting(0, 2min), app.facility);
  both.answered(weather, 0);
  EXPECT_EQ(both.resting(0, 2min), weather);
  both.completed(weather); // reset
  EXPECT_FALSE(both.resting(0, 2min));
}

TEST_F(Order, UnregisteredTopicsTakeNoPart) {
  app.program.topics[app.taxi].initiative = script::Initiative::system;
  order.activate(app.appointment);
  order.activate(app.facility);
  order.unregister_topic(app.appointment);
  order.unregister_topic(app.taxi);
  EXPECT_EQ(order.deaf(), (std::vector{app.appointment, app.taxi}));
  EXPECT_FALSE(order.next());
  order.unregister_topic(app.facility);
  EXPECT_FALSE(order.current());
  order.register_topic(app.taxi);
  EXPECT_EQ(order.next()->topic, app.taxi);
}

} // namespace

} // namespace parlour::dialogue
