// Timers and waits of scripts.
#include <gtest/gtest.h>

#include "script/dialogue/engine/effects/time_effects.hpp"
#include "tests/script/dialogue/bell.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

TEST(TimeEffects, TimersRepeatUntilCancelledAndKeepTheirLocals) {
  Bell world(R"xml(<if cond="_LPARAM1 == 'stop'"><cancel timer="tick"/>
    <else><var name="n" expr="_LPARAM1"/>
    <timer name="tick" after="1s" repeat="true"><speak param="Tick {n}."/>
    </timer><set name="n" expr="0"/></else></if>)xml");
  world.ring({7});
  world.advance(2500ms);
  EXPECT_EQ(world.said(), (Texts{"Tick 7.", "Tick 7."}));
  world.ring({"stop"});
  world.advance(5s);
  EXPECT_EQ(world.said(), Texts{});
}

TEST(TimeEffects, WaitGoesOnAfterAWhile) {
  Bell world("<speak param='One.'/><wait for='1s'/><speak param='Two.'/>");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"One."});
  world.advance(1s);
  EXPECT_EQ(world.said(), Texts{"Two."});
}

TEST(TimeEffects, WhatIsAskedForHappensAtTheWait) {
  Bell world("<activate topic='T'/><wait for='1s'/><speak param='After.'/>",
             "<topic name='T'><slot name='S' type='Functional' question='S?'/>"
             "</topic>");
  world.ring();
  EXPECT_EQ(world.said(), Texts{"S?"});
  world.advance(1s);
  EXPECT_EQ(world.said(), Texts{"After."});
}

TEST(TimeEffects, AWaitInATopicHoldsNothingElse) {
  Bell world("<speak param='Bell.'/>", R"xml(
    <topic name="T"><slot name="S" type="Functional" question="S?">
      <filled><activate topic="U"/><wait for="1s"/><speak param="Waited."/>
      </filled></slot></topic>
    <topic name="U"><slot name="R" type="Functional" question="R?"/></topic>
    )xml");
  world.say(inform("T", {{"S", 1}}));
  world.say(inform("U", {{"R", 1}}));
  EXPECT_EQ(world.slot("U", "R"), 1);
  world.ring();
  EXPECT_EQ(world.said(), (Texts{"R?", "Bell."}));
  world.advance(1s);
  EXPECT_EQ(world.said().front(), "Waited.");
}

} // namespace
} // namespace parlour::dialogue
