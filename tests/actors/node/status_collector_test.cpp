#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>

#include "actors/node/status_collector.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

class StatusCollectorTest : public NodeFixture {
protected:
  // The first of the kind; of that name, where one is given.
  ActorStatus of(const std::string& kind, const std::string& name = "") {
    for (const auto& one : node->status())
      if (one.kind == kind && (name.empty() || one.name == name))
        return one;
    ADD_FAILURE() << "there is no " << kind << " " << name;
    return {};
  }
};

constexpr const char* busy = R"(
  <state name="Welcome"><Entrance>
    <timer name="tea" after="3s"><speak param="Tea."/></timer>
  </Entrance></state>)";

TEST_F(StatusCollectorTest, EveryActorTellsHowItIs) {
  options.components = {answering("Ear", "KeywordSpotter", "Keyword")};
  start(busy, "", "Welcome");
  const auto id = node->open(seat);
  node->run_until_quiet();
  EXPECT_THAT(of("message_centre").doing,
              HasSubstr(" messages routed, 0 taken by nobody"));
  EXPECT_EQ(of("session_manager").doing, "1 sessions at 1 seats");
  EXPECT_EQ(of("supervisor").doing, "1 components");
  EXPECT_EQ(of("file_keeper").doing, "waits");
  EXPECT_EQ(of("component_host", "Ear").doing, "waits");
  EXPECT_EQ(of("seat", seat).doing, "waits"); // nothing was said yet
  EXPECT_THAT(of("session", id).doing, HasSubstr(" in state Welcome"));
  std::vector<std::string> timers;
  for (const auto& one : node->status())
    if (one.kind == "timer")
      timers.push_back(one.doing);
  EXPECT_THAT(timers, testing::Contains("rings in 3000 ms"));
  for (const auto& one : node->status())
    EXPECT_TRUE(one.answered) << one.kind;
}

TEST_F(StatusCollectorTest, AQueryTellsWhatItWaitsFor) {
  options.components = {component("db", "Database", [](auto&, auto&) {})};
  start(R"(<state name="Welcome"><Entrance>
    <connectdb name="db" param=""/><querydb db="db" param="select 1"/>
  </Entrance></state>)",
        "", "Welcome");
  const auto id = node->open(seat);
  EXPECT_EQ(of("query").doing, "waits for Query");
  EXPECT_EQ(of("session", id).doing, "waits for an answer in state Welcome");
}

TEST_F(StatusCollectorTest, TellsWhatWentWrongLast) {
  options.components = {component("City", "Taxi", [](auto&, auto&) {
    throw std::runtime_error("engine trouble");
  })};
  start(R"(<handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult><post module="Taxi" command="Book"/>
      <speak param="{1 / 0}"/></RecognitionResult></ASR>
  </component></messages></handler>)");
  say({"home"});
  EXPECT_EQ(of("supervisor").last_error, "City failed: engine trouble");
  EXPECT_EQ(of("component_host", "City").last_error, "engine trouble");
  EXPECT_NE(of("session").last_error, "");
}

TEST_F(StatusCollectorTest, TellsOfComponentsThatAreNotThere) {
  options.components = {component("City", "Taxi", [](auto&, auto&) {
    throw std::runtime_error("engine trouble");
  })};
  start(R"(<handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult><post module="Taxi" command="Book"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  say({"one"});
  say({"two"});
  EXPECT_EQ(of("supervisor").doing, "1 components; City is backing off");
}

TEST_F(StatusCollectorTest, WhatIsPrivateIsMasked) {
  options.components = {component("City", "Taxi", [](auto&, auto&) {
    throw std::runtime_error("the pin 4711 is wrong");
  })};
  start(R"(<var name="pin" private="true"/>
    <handler name="Pipeline"><messages><component><ASR><RecognitionResult>
      <set name="pin" expr="_LPARAM1"/>
      <post module="Taxi" command="Book" param="pin"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  say({"4711"});
  EXPECT_EQ(of("component_host").last_error, "the pin *** is wrong");
  EXPECT_EQ(of("supervisor").last_error, "City failed: the pin *** is wrong");
}

// Really a thread that does not come back until the test lets it.
TEST_F(StatusCollectorTest, DoesNotWaitForACallThatDoesNotReturn) {
  std::mutex mutex;
  std::condition_variable changed;
  bool entered = false;
  bool released = false;
  options.virtual_start.reset();
  options.components = {component("Ear", "KeywordSpotter", [&](auto&, auto&) {
    std::unique_lock lock(mutex);
    entered = true;
    changed.notify_all();
    changed.wait(lock, [&] { return released; });
  })};
  start(R"(<handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <post module="KeywordSpotter" command="Process" param="x"/>
    </RecognitionResult></ASR></component></messages></handler>)");
  node->enter(seat, {"one", "two"});
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return entered; });
  }
  const auto ear = of("component_host", "Ear");
  EXPECT_FALSE(ear.answered);
  EXPECT_TRUE(ear.call_since);
  EXPECT_TRUE(of("session_manager").answered);
  {
    std::lock_guard lock(mutex);
    released = true;
    changed.notify_all();
  }
  EXPECT_TRUE(node->stop());
}

} // namespace
} // namespace parlour::actors
