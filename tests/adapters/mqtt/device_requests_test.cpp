#include "adapters/mqtt/device_requests.hpp"
#include "tests/adapters/mqtt/device_policy_fixture.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

using DeviceRequestsTest = DevicePolicyTest;

TEST_F(DeviceRequestsTest, ALampIsOnWhenItSaysSo) {
  begin();
  set("lamp", "kitchen", "on");
  EXPECT_THAT(lines(), ElementsAre("publish lamp/c ON"));
  says("lamp/s", "OFF");
  EXPECT_THAT(lines(), ElementsAre("news lamp Kitchen off"));
  says("lamp/s", "ON");
  EXPECT_THAT(lines(), ElementsAre("State lamp kitchen on"));
  ask("lamp", "Kitchen");
  EXPECT_THAT(lines(), ElementsAre("State lamp Kitchen on"));
  EXPECT_EQ(policy.next_moment(), Moment::max());
}

TEST_F(DeviceRequestsTest, ASilentLampDoesNotAnswer) {
  begin();
  set("lamp", "kitchen", "on");
  lines();
  EXPECT_EQ(policy.next_moment(), now + patience);
  wait(patience - Milliseconds(1));
  EXPECT_THAT(lines(), IsEmpty());
  wait(Milliseconds(1));
  EXPECT_THAT(lines(),
              ElementsAre("Failed The lamp in the kitchen does not answer."));
  says("lamp/s", "ON");
  EXPECT_THAT(lines(), ElementsAre("news lamp Kitchen on"));
}

// Some tell only what changes.
TEST_F(DeviceRequestsTest, ALampThatIsOnAlreadyNeedNotSayIt) {
  begin();
  says("lamp/s", "ON", true);
  set("lamp", "kitchen", "on");
  EXPECT_THAT(lines(), ElementsAre("publish lamp/c ON"));
  wait(patience);
  EXPECT_THAT(lines(), ElementsAre("State lamp kitchen on"));
}

TEST_F(DeviceRequestsTest, ALockMustSayIt) {
  begin();
  says("door/s", "LOCKED", true);
  set("door", "hall", "closed");
  EXPECT_THAT(lines(), ElementsAre("publish door/c LOCK"));
  wait(patience);
  EXPECT_THAT(lines(),
              ElementsAre("Failed The door in the hall does not answer."));
  set("door", "hall", "open");
  says("door/s", "UNLOCKING");
  wait(patience);
  EXPECT_THAT(lines(),
              ElementsAre("publish door/c UNLOCK", "news door Hall opening",
                          "Failed The door in the hall says "
                          "'opening'."));
  set("door", "hall", "open");
  says("door/s", "UNLOCKED");
  EXPECT_THAT(lines(),
              ElementsAre("publish door/c UNLOCK", "State door hall open"));
  set("door", "hall", "closed");
  says("door/s", "JAMMED");
  EXPECT_THAT(lines(), ElementsAre("publish door/c LOCK",
                                   "Failed The door in the hall is jammed."));
}

// A message that the server had kept shows nothing about a new order.
TEST_F(DeviceRequestsTest, ARetainedStateIsNoObedience) {
  begin();
  set("door", "hall", "open");
  says("door/s", "UNLOCKED", true);
  EXPECT_THAT(lines(), ElementsAre("publish door/c UNLOCK"));
  says("door/s", "UNLOCKED");
  EXPECT_THAT(lines(), ElementsAre("State door hall open"));
}

TEST_F(DeviceRequestsTest, OneOfTwoLocksIsNotOpenedByGuess) {
  begin();
  announce("lock/back", R"({"name": "back", "stat_t": "b/s", "cmd_t": "b/c",
                            "dev": {"sa": "Hall"}})");
  wait(settle);
  lines();
  set("door", "hall", "open");
  EXPECT_THAT(lines(),
              ElementsAre("Failed There are several in the hall: back, "
                          "front."));
}

TEST_F(DeviceRequestsTest, TwoLampsAreSwitchedTogether) {
  begin();
  announce("light/second", lamp("second"));
  wait(settle);
  lines();
  set("lamp", "kitchen", "on");
  EXPECT_THAT(lines(),
              UnorderedElementsAre("publish lamp/c ON", "publish second/c ON"));
  says("second/s", "ON");
  EXPECT_THAT(lines(), IsEmpty());
  says("lamp/s", "ON");
  EXPECT_THAT(lines(), ElementsAre("State lamp kitchen on"));
  says("lamp/s", "OFF");
  lines();
  ask("lamp", "kitchen"); // one of them is on
  EXPECT_THAT(lines(), ElementsAre("State lamp kitchen on"));
  set("lamp", "kitchen", "off");
  says("second/s", "OFF");
  lines();
  wait(patience); // the other one was off before
  EXPECT_THAT(lines(), ElementsAre("State lamp kitchen off"));
}

TEST_F(DeviceRequestsTest, ALaterOrderCountsInsteadOfAnEarlierOne) {
  begin();
  set("lamp", "kitchen", "on");
  set("lamp", "kitchen", "on");
  set("lamp", "kitchen", "off");
  EXPECT_THAT(lines(), ElementsAre("publish lamp/c ON", "publish lamp/c ON",
                                   "Failed Another order has come in between.",
                                   "Failed Another order has come in between.",
                                   "publish lamp/c OFF"));
  says("lamp/s", "OFF");
  EXPECT_THAT(lines(), ElementsAre("State lamp kitchen off"));
  EXPECT_EQ(policy.next_moment(), Moment::max());
}

TEST_F(DeviceRequestsTest, WithoutAStateTheReceiptCounts) {
  begin();
  announce("light/plain", R"({"cmd_t": "plain/c", "dev": {"sa": "Attic"},
                              "ret": true})");
  wait(settle);
  lines();
  set("lamp", "attic", "on");
  EXPECT_THAT(lines(), ElementsAre("publish plain/c ON retained"));
  policy.published(77, now);
  EXPECT_THAT(lines(), IsEmpty());
  policy.published(1, now);
  EXPECT_THAT(lines(), ElementsAre("State lamp attic on"));
  ask("lamp", "attic");
  EXPECT_THAT(lines(), ElementsAre("State lamp attic on"));
  set("lamp", "attic", "off");
  policy.not_published(2);
  EXPECT_THAT(lines(),
              ElementsAre("publish plain/c OFF retained",
                          "Failed The lamp in the attic does not answer."));
}

TEST_F(DeviceRequestsTest, NumbersAreSetAndRead) {
  begin();
  announce("climate/h", R"({"temp_cmd_t": "h/c", "temp_stat_t": "h/s",
                            "max_temp": 30, "dev": {"sa": "Kitchen"}})");
  wait(settle);
  lines();
  set("heating", "kitchen", 21);
  says("h/s", "21.0");
  EXPECT_THAT(lines(),
              ElementsAre("publish h/c 21", "State heating kitchen 21"));
  set("heating", "kitchen", 31);
  EXPECT_THAT(lines(), ElementsAre("Failed The heating in the kitchen takes 7 "
                                   "to 30, not '31'."));
}

TEST_F(DeviceRequestsTest, WhoAsksWaitsForTheFirstState) {
  begin();
  ask("lamp", "kitchen");
  EXPECT_THAT(lines(), IsEmpty());
  says("lamp/s", "OFF", true);
  EXPECT_THAT(lines(), ElementsAre("State lamp kitchen off"));
  ask("door", "hall");
  wait(patience);
  EXPECT_THAT(lines(), ElementsAre("Failed The door in the hall has not said "
                                   "anything yet."));
}

TEST_F(DeviceRequestsTest, WhatIsUnavailableDoesNotAnswer) {
  begin();
  says("lamp/there", "offline", true);
  set("lamp", "kitchen", "on");
  ask("lamp", "kitchen");
  EXPECT_THAT(lines(),
              ElementsAre("Failed The lamp in the kitchen does not answer.",
                          "Failed The lamp in the kitchen does not answer."));
  says("lamp/there", "rubbish");
  says("lamp/there", "online");
  set("lamp", "kitchen", "on");
  EXPECT_THAT(lines(), ElementsAre("publish lamp/c ON"));
}

TEST_F(DeviceRequestsTest, RefusesWhatItCannotDo) {
  begin();
  set("lamp", "cellar", "on");
  set("oven", "kitchen", "on");
  set("lamp", "kitchen", "dim");
  order("Set", {"lamp"});
  order("Dance", {"lamp", "kitchen"});
  EXPECT_THAT(
      lines(),
      ElementsAre("Failed There is no 'lamp' in 'cellar'.",
                  "Failed There is no 'oven' in 'kitchen'; there is: lamp.",
                  "Failed The lamp in the kitchen takes on or off, not 'dim'.",
                  "Failed Set needs a device and a room.",
                  "Failed There is no command 'Dance' here."));
}

TEST_F(DeviceRequestsTest, LimitsHowManyWait) {
  for (std::size_t i = 0; i < DeviceRequests::max_pending; ++i)
    ask("lamp", "kitchen");
  EXPECT_THAT(lines(), IsEmpty());
  ask("lamp", "kitchen");
  EXPECT_THAT(lines(), ElementsAre("Failed Too many wait for the devices."));
}

} // namespace
} // namespace parlour::adapters::mqtt
