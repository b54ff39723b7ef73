#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "actors/support/observer.hpp"

namespace parlour::actors {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Message rings(const std::string& source = "Bell") {
  Message message;
  message.source = source;
  message.command = "Rings";
  message.params = {"secret"};
  message.session = "s1";
  return message;
}

class ObserverTest : public testing::Test {
protected:
  ObserverTest() {
    watcher.on_inspection = [this](const Inspection& seen) {
      shown.push_back(seen);
    };
    watcher.on_log = [this](const std::string& line) { logs.push_back(line); };
  }

  Observer::Watcher watcher;
  std::atomic<bool> left_behind = false;
  std::vector<Inspection> shown;
  std::vector<std::string> logs;
};

TEST_F(ObserverTest, ShowsMessagesOnTheirWay) {
  Observer observer(watcher, left_behind);
  EXPECT_TRUE(observer.watches_all());
  ASSERT_TRUE(observer.follows_messages());
  observer.follow(rings(), "-> Ear");
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].kind, InspectionKind::message);
  EXPECT_EQ(shown[0].subject, "Bell.Rings");
  EXPECT_EQ(shown[0].way, "-> Ear");
  EXPECT_EQ(shown[0].message->command, "Rings");
  EXPECT_THAT(logs, IsEmpty());
}

TEST_F(ObserverTest, LogsTroubleWhereNobodyWatches) {
  watcher.on_inspection = {};
  Observer observer(watcher, left_behind);
  EXPECT_FALSE(observer.watches_all());
  EXPECT_FALSE(observer.follows_messages());
  observer.inspect({InspectionKind::error, "", "Type", "a.xml:3: no"});
  observer.inspect({InspectionKind::log, "", "info", "here"});
  observer.inspect({InspectionKind::slot, "", "T.S", ""});
  observer.inspect({InspectionKind::unhandled, "", "", "nobody is in",
                    std::make_shared<const Message>(rings())});
  EXPECT_THAT(logs, ElementsAre("Type: a.xml:3: no", "info: here",
                                "Bell.Rings(secret): nobody is in"));
}

TEST_F(ObserverTest, FollowsNothingForWhoWatchesTroubleOnly) {
  watcher.all = false;
  Observer observer(watcher, left_behind);
  EXPECT_FALSE(observer.watches_all());
  EXPECT_FALSE(observer.follows_messages());
  observer.inspect({InspectionKind::error, "", "", ""});
  EXPECT_EQ(shown.size(), 1u);
}

TEST_F(ObserverTest, ShowsAllForAsLongAsSomebodyWants) {
  watcher.all = false;
  Observer observer(watcher, left_behind);
  const auto& follows = observer.follows_messages();
  EXPECT_TRUE(observer.may_follow());
  observer.watch_all(true);
  EXPECT_TRUE(observer.watches_all());
  EXPECT_TRUE(follows);
  observer.follow(rings(), "-> Ear");
  EXPECT_EQ(shown.size(), 1u);
  observer.watch_all(false);
  EXPECT_FALSE(observer.watches_all());
  EXPECT_FALSE(follows);
}

TEST_F(ObserverTest, WhoWatchesAllAnywayGoesOn) {
  Observer observer(watcher, left_behind);
  observer.watch_all(true);
  observer.watch_all(false);
  EXPECT_TRUE(observer.watches_all());
}

TEST_F(ObserverTest, CountsWhatScriptsHaveFailedAt) {
  Observer observer({}, left_behind);
  EXPECT_FALSE(observer.may_follow());
  observer.inspect({InspectionKind::error, "s1", "", ""});
  observer.inspect({InspectionKind::slot, "s1", "", ""});
  EXPECT_EQ(observer.metrics().script_errors.value(), 1u);
}

TEST_F(ObserverTest, MasksWhatIsPrivate) {
  watcher.is_heard = [](const Message&) { return false; };
  for (const bool exact : {false, true}) {
    shown.clear();
    logs.clear();
    watcher.exact = exact;
    Observer observer(watcher, left_behind);
    observer.discretion().conceal("s1", {"secret"});
    observer.follow(rings(), "-> Ear");
    observer.log("a secret");
    ASSERT_EQ(shown.size(), 1u);
    EXPECT_EQ(shown[0].detail.find("secret") != std::string::npos, exact);
    ASSERT_EQ(logs.size(), 1u);
    EXPECT_EQ(logs[0].find("secret"), std::string::npos);
  }
}

TEST_F(ObserverTest, LogsThatWhoWatchesFailed) {
  watcher.on_inspection = [](const auto&) {
    throw std::runtime_error("blind");
  };
  for (const bool discreet : {false, true}) {
    if (discreet)
      watcher.is_heard = [](const Message&) { return false; };
    logs.clear();
    Observer observer(watcher, left_behind);
    observer.inspect({InspectionKind::error, "s1", "", ""});
    EXPECT_THAT(logs, ElementsAre("who watches failed: blind"));
  }
}

TEST_F(ObserverTest, MasksWhyWhoWatchesFailed) {
  watcher.is_heard = [](const Message&) { return false; };
  watcher.on_inspection = [](const auto&) {
    throw std::runtime_error("no line for a secret");
  };
  Observer observer(watcher, left_behind);
  observer.discretion().conceal("s1", {"secret"});
  observer.inspect({InspectionKind::error, "s1", "", ""});
  EXPECT_THAT(logs, ElementsAre("who watches failed: no line for a ***"));
}

TEST_F(ObserverTest, TellsNobodyWhatIsLeftBehind) {
  Observer observer(watcher, left_behind);
  left_behind = true;
  observer.inspect({InspectionKind::error, "", "", ""});
  observer.log("late");
  EXPECT_THAT(shown, IsEmpty());
  EXPECT_THAT(logs, IsEmpty());
}

} // namespace
} // namespace parlour::actors
