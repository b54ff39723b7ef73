#include "tests/adapters/mqtt/device_policy_fixture.hpp"

namespace parlour::adapters::mqtt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
using testing::UnorderedElementsAre;

// -- subscriptions ------------------------------------------------------------

TEST_F(DevicePolicyTest, SubscribesToWhatIsAnnounced) {
  connect();
  EXPECT_THAT(lines(), ElementsAre("subscribe ha/+/+/config",
                                   "subscribe ha/+/+/+/config"));
  announce("light/lamp", lamp());
  EXPECT_THAT(lines(), ElementsAre("subscribe lamp/s", "subscribe lamp/there"));
  announce("light/lamp", lamp());
  EXPECT_THAT(lines(), IsEmpty());
  announce("light/lamp", "");
  EXPECT_THAT(lines(), UnorderedElementsAre("unsubscribe lamp/s",
                                            "unsubscribe lamp/there"));
}

TEST_F(DevicePolicyTest, SubscribesAnewWithEachConnection) {
  begin();
  policy.disconnected("it is gone");
  announce("light/late", lamp("late"));
  EXPECT_THAT(lines(), IsEmpty());
  connect();
  EXPECT_THAT(lines(), UnorderedElementsAre(
                           "subscribe ha/+/+/config",
                           "subscribe ha/+/+/+/config", "subscribe lamp/s",
                           "subscribe lamp/there", "subscribe door/s",
                           "subscribe late/s", "subscribe late/there"));
}

TEST_F(DevicePolicyTest, CountsOnceAllAreKnown) {
  connect();
  announce("light/lamp", lamp());
  announce("camera/x", "{}");
  announce("switch/plug", R"({"cmd_t": "c"})");
  lines();
  EXPECT_EQ(policy.next_moment(), now + settle);
  wait(settle);
  EXPECT_THAT(lines(), ElementsAre("log 2 devices are known; the application "
                                   "speaks of 1"));
  EXPECT_EQ(policy.next_moment(), Moment::max());
}

// -- when there is no connection ----------------------------------------------

TEST_F(DevicePolicyTest, HoldsRequestsUntilDevicesAreKnown) {
  ask("lamp", "kitchen");
  set("lamp", "kitchen", "on");
  EXPECT_THAT(lines(), IsEmpty());
  connect();
  wait(settle - Milliseconds(1));
  announce("light/lamp", lamp());
  says("lamp/s", "OFF", true);
  wait(settle - Milliseconds(1));
  lines();
  wait(Milliseconds(1));
  EXPECT_THAT(lines(), ElementsAre(StartsWith("log"), "State lamp kitchen off",
                                   "publish lamp/c ON"));
}

// Whoever goes on announcing holds nobody up for ever.
TEST_F(DevicePolicyTest, DoesNotHoldThemForEver) {
  connect();
  lines();
  ask("lamp", "cellar");
  for (int i = 0; i < 30; ++i) {
    announce("light/lamp", lamp());
    wait(Milliseconds(200));
  }
  EXPECT_THAT(lines(), testing::Contains(HasSubstr("Failed")));
}

TEST_F(DevicePolicyTest, AServerThatDoesNotAnswerIsSaid) {
  ask("lamp", "kitchen");
  wait(patience);
  EXPECT_THAT(lines(),
              ElementsAre("Failed The devices' server does not answer."));
}

TEST_F(DevicePolicyTest, FailsWhatWaitsWhenTheConnectionIsLost) {
  begin();
  set("lamp", "kitchen", "on");
  ask("door", "hall");
  lines();
  policy.disconnected("it is gone");
  const auto* down = "Failed The devices' server cannot be reached: it is "
                     "gone.";
  EXPECT_THAT(lines(), ElementsAre(down, down));
  ask("lamp", "kitchen");
  EXPECT_THAT(lines(), ElementsAre(down));
  EXPECT_EQ(policy.next_moment(), Moment::max());
}

TEST_F(DevicePolicyTest, AnswersAllInTheEnd) {
  ask("lamp", "kitchen");
  policy.end();
  EXPECT_THAT(lines(), ElementsAre(HasSubstr("the component is stopped")));
}

// -- what devices say by themselves -------------------------------------------

TEST_F(DevicePolicyTest, TellsWhatChanges) {
  begin();
  announce("event/bell", R"({"stat_t": "bell", "dev": {"sa": "Hall"}})");
  announce("number/x", R"({"stat_t": "x"})");
  announce("switch/plug", R"({"stat_t": "plug", "cmd_t": "c"})");
  lines();
  says("lamp/s", "ON", true); // not new
  says("lamp/s", "ON");
  EXPECT_THAT(lines(), IsEmpty());
  says("lamp/s", "OFF");
  says("bell", R"({"event_type": "press"})");
  says("bell", R"({"event_type": "press"})");
  says("plug", "ON"); // the application has no word for it
  EXPECT_THAT(lines(),
              ElementsAre("news lamp Kitchen off", "news bell Hall press",
                          "news bell Hall press"));
}

TEST_F(DevicePolicyTest, DoesNotTellMoreThanConversationsCanBear) {
  begin();
  for (int i = 0; i < 10'000; ++i)
    says("lamp/s", i % 2 == 0 ? "ON" : "OFF");
  const auto told = lines();
  EXPECT_EQ(std::ranges::count_if(told,
                                  [](const std::string& line) {
                                    return line.starts_with("news");
                                  }),
            200);
  EXPECT_EQ(std::ranges::count_if(told,
                                  [](const std::string& line) {
                                    return line.starts_with("log");
                                  }),
            1);
  EXPECT_EQ(policy.count(Complaint::news), 9'800u);
  wait(Milliseconds(1'000));
  says("lamp/s", "ON");
  EXPECT_THAT(lines(), ElementsAre("news lamp Kitchen on"));
}

TEST_F(DevicePolicyTest, ComplainsOnceAboutRubbish) {
  begin();
  for (int i = 0; i < 100; ++i) {
    says("lamp/s", "dim");
    announce("light/broken" + std::to_string(i), "{");
  }
  EXPECT_THAT(lines(),
              ElementsAre("log 'dim' is no state of 'ha/light/lamp/config'",
                          "log ha/light/broken0/config: this is no JSON "
                          "object"));
  EXPECT_EQ(policy.count(Complaint::state), 100u);
  EXPECT_EQ(policy.count(Complaint::announcement), 100u);
}

TEST_F(DevicePolicyTest, IgnoresWhatIsTooLongOrNoText) {
  begin();
  says("lamp/s", std::string(DevicePolicy::max_payload + 1, 'x'));
  EXPECT_THAT(lines(), ElementsAre(HasSubstr("has 262145 bytes")));
  says("lamp/s", "\xff\xfe");
  EXPECT_THAT(lines(), ElementsAre(HasSubstr("is no text in UTF-8")));
  says("nobody/reads/this", "{");
  EXPECT_THAT(lines(), IsEmpty());
}

TEST_F(DevicePolicyTest, CutsLongQuotations) {
  begin();
  says("lamp/s", std::string(99, 'x') + "ééééé");
  EXPECT_THAT(lines(), ElementsAre("log '" + std::string(99, 'x') +
                                   "…' is no state of 'ha/light/lamp/config'"));
}

TEST_F(DevicePolicyTest, HasALimitOfDevices) {
  connect();
  for (std::size_t i = 0; i <= DeviceTable::max_devices; ++i)
    announce("light/" + std::to_string(i), lamp(std::to_string(i)));
  EXPECT_EQ(policy.count(Complaint::number), 1u);
}

} // namespace
} // namespace parlour::adapters::mqtt
