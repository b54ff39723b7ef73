// Events that scripts raise themselves: their limit, and timers that are lost
// when a session ends.
#include <gtest/gtest.h>

#include "tests/script/dialogue/bell.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(InternalEvents, MoreThanAHundredInternalEventsAreStopped) {
  Bell world("<fire event='Again'/>", R"xml(
<var name="count" expr="0"/>
<handler name="E"><messages><component><Script><Again>
  <set name="count" expr="count + 1"/><fire event="Again"/>
  </Again></Script>
  <Bell><Ask><speak param="{count}"/></Ask></Bell></component></messages>
</handler>)xml");
  world.ring();
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 1u);
  const auto said = world.said();
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(said[0].starts_with("[unavailable {reason: more than 100"));
  world.event("Bell", "Ask");
  EXPECT_EQ(world.said(), Texts{"100"});
}

TEST(InternalEvents, TooManyInternalEventsAreAnEventForWhoHandlesErrors) {
  Bell world("<fire event='Again'/>", R"xml(
<handler name="E"><messages><component><Script>
  <Again><fire event="Again"/></Again>
  <Error><speak param="{_LPARAM1}"/><fire event="Again"/></Error>
</Script></component></messages></handler>)xml");
  for (int time = 0; time < 2; ++time) {
    world.ring();
    EXPECT_EQ(world.said(), Texts{"more than 100 internal events without an "
                                  "external one; the rest is dropped"});
  }
  EXPECT_EQ(world.seen(InspectionKind::error).size(), 2u);
}

TEST(InternalEvents, ATimerThatIsLostIsTold) {
  Bell world("<timer name='tea' after='10m'><speak param='Tea.'/></timer>"
             "<timer name='tick' after='1s' repeat='true'/>"
             "<timer name='advice' after='5m' keeps-open='false'/>");
  world.ring();
  world.advance(1min);
  world.take(input::Closed());
  EXPECT_TRUE(world.has_ended);
  EXPECT_EQ(world.seen(InspectionKind::log),
            (Texts{"warning: the timer 'tea' is lost with its session; it was "
                   "due at 2026-11-21 09:10:00",
                   "warning: the timer 'advice' is lost with its session; it "
                   "was due at 2026-11-21 09:05:00"}));
  world.advance(1h);
  EXPECT_EQ(world.said(), Texts{});
}

} // namespace
} // namespace parlour::dialogue
