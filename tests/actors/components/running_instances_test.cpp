#include <condition_variable>
#include <future>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "actors/components/running_instances.hpp"
#include "tests/actors/plugin_shelf.hpp"

namespace parlour::actors {
namespace {

using RunningInstancesTest = LoadingTest;

// A taxi company whose first instance, for what is said, does what a test says.
using Misbehaviour = std::function<void(FunctionPlugin&, const Message&)>;

ComponentOrder troubled(const std::string& name, const std::string& word,
                        Misbehaviour misbehave) {
  auto order = taxi(name);
  order.factory.create = [=, number = std::make_shared<std::atomic<int>>(0)] {
    const auto mine = name + std::to_string(++*number);
    return std::make_unique<FunctionPlugin>(
        [=](FunctionPlugin& self, const Message& message) {
          const auto asked = message.params.at(0).text();
          if (asked == word)
            misbehave(self, message);
          self.fire_event("Booked", {mine + " for " + asked});
        });
  };
  return order;
}

ComponentOrder throwing(const std::string& name) {
  return troubled(name, "crash", [](auto&, auto&) {
    throw std::runtime_error("engine trouble");
  });
}

TEST_F(RunningInstancesTest, AnotherInstanceTakesThePlaceOfOneThatThrew) {
  options.components = {throwing("City")};
  start(load_and_ask);
  EXPECT_THAT(say({"home"}), ElementsAre("City1 for home"));
  EXPECT_THAT(say({"crash", "work"}),
              ElementsAre("Refused: City: engine trouble", "City2 for work"));
  EXPECT_THAT(heard(),
              ElementsAre("failed City: engine trouble 1", "up City Taxi"));
}

TEST_F(RunningInstancesTest, WaitsLongerAfterEachFailure) {
  options.components = {throwing("City")};
  start(load_and_ask);
  say({"crash"});
  EXPECT_THAT(say({"crash", "home"}), ElementsAre(HasSubstr("trouble")));
  EXPECT_TRUE(node->step_to_next_due(100ms));
  EXPECT_EQ(node->now(), nine_o_clock + 100);
  EXPECT_THAT(said(), ElementsAre("City3 for home")); // it has waited
}

TEST_F(RunningInstancesTest, ARoleFallsToItsNextComponent) {
  options.components = {throwing("City"), taxi("Country")};
  start(load_and_ask, R"(<sessions closes-after="1h"/>)");
  for (int i = 0; i < 5; ++i) {
    EXPECT_THAT(say({"crash"}), ElementsAre(HasSubstr("engine trouble")));
    node->advance(1s);
  }
  EXPECT_THAT(heard(), testing::Contains("down City: engine trouble"));
  EXPECT_THAT(say({"home"}), ElementsAre("Country for home"));
  node->advance(1min);
  node->run_until_quiet();
  EXPECT_THAT(heard(), ElementsAre("up City Taxi"));
  EXPECT_THAT(say({"home"}), ElementsAre("City6 for home"));
}

TEST_F(RunningInstancesTest, WhoWaitsForOneThatIsDownIsToldAtOnce) {
  options.components = {troubled("City", "later", [](auto& self, auto&) {
    self.host().failed("its line was cut");
    throw std::runtime_error("not heard any more");
  })};
  start(load_and_ask);
  for (int i = 0; i < 4; ++i) {
    say({"later"});
    node->advance(1s);
  }
  EXPECT_THAT(say({"later"}), ElementsAre("Refused: City: its line was cut"));
  EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("Offline: ")));
}

// The call returns when its component has long been replaced.
TEST_F(RunningInstancesTest, GivesUpACallThatDoesNotReturn) {
  options.components = {
      troubled("City", "wait", [this](auto& self, const Message&) {
        node->advance(5s);
        node->run_until_quiet();
        EXPECT_THAT(said(), ElementsAre(HasSubstr("within 5000 ms")));
        EXPECT_THAT(say({"meanwhile"}), ElementsAre("City2 for meanwhile"));
        self.host().after(1s, [] { FAIL() << "called back"; });
      })};
  options.components[0].policy.deadline = 5s;
  start(load_and_ask);
  EXPECT_THAT(say({"wait"}), IsEmpty()); // what it said late is not heard
  node->advance(5s);
  EXPECT_THAT(heard(), ElementsAre(HasSubstr("failed City: a call did not"),
                                   "up City Taxi"));
  EXPECT_THAT(say({"home"}), ElementsAre("City2 for home"));
}

TEST_F(RunningInstancesTest, TheDeadlineIsTheComponents) {
  options.components = {troubled("City", "wait", [this](auto&, auto&) {
    node->advance(999ms);
    node->run_until_quiet();
    EXPECT_THAT(said(), IsEmpty());
    node->advance(1ms);
    node->run_until_quiet();
    EXPECT_THAT(said(), ElementsAre(HasSubstr("within 1000 ms")));
  })};
  options.components[0].policy.deadline = 1s;
  start(load_and_ask);
  say({"wait"});
}

// What it does from a thread of its own, too.
TEST_F(RunningInstancesTest, StopsAFlood) {
  options.components = {troubled("City", "flood", [](auto& self, auto&) {
    Message noise;
    noise.command = "Noise";
    for (int i = 0; i < 100'000; ++i)
      self.host().fire_event(noise);
  })};
  start(load_and_ask);
  EXPECT_THAT(say({"flood"}), ElementsAre(HasSubstr("floods the node")));
  EXPECT_LE(ways_of("Noise").size(), 2'100u);
  EXPECT_THAT(heard(),
              ElementsAre(HasSubstr("failed City: it floods"), "up City Taxi"));
  EXPECT_THAT(say({"home"}), ElementsAre("City2 for home"));
}

TEST_F(RunningInstancesTest, APluginMaySayThatItIsBroken) {
  options.components = {troubled("City", "cut", [](auto& self, auto&) {
    std::thread([&] { self.host().failed("its line was cut"); }).join();
  })};
  start(load_and_ask);
  // The answer was said before anybody knew.
  EXPECT_THAT(say({"cut"}), ElementsAre("City1 for cut"));
  EXPECT_THAT(heard(),
              ElementsAre("failed City: its line was cut 1", "up City Taxi"));
  EXPECT_THAT(say({"home"}), ElementsAre("City2 for home"));
}

// It owes an answer that will not come.
TEST_F(RunningInstancesTest, WhoWaitsForABrokenInstanceIsToldAtOnce) {
  options.components = {
      component("City", "Taxi", [](auto& self, const Message& message) {
        if (message.params.at(0) == Value("crash"))
          throw std::runtime_error("engine trouble");
        self.host().after(1min, [&] { self.fire_event("Booked", {"never"}); });
      })};
  start(R"(
    <handler name="Pipeline"><messages><component>
      <ASR><RecognitionResult>
        <if cond="_LPARAM1 eq 'crash'">
          <post module="Taxi" command="Book" param="_LPARAM1"/>
        <else>
          <try><request module="Taxi" command="Book" param="_LPARAM1"/>
            <catch name="e"><speak param="{e.message}"/></catch></try>
        </else></if>
      </RecognitionResult></ASR>
    </component></messages></handler>)");
  EXPECT_THAT(say({"home"}), IsEmpty());
  node->inject("", [] {
    Message message;
    message.source = "Script";
    message.command = "Book";
    message.params = {"crash"};
    message.sinks = {"Taxi"};
    return message;
  }());
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("City: engine trouble"));
}

TEST_F(RunningInstancesTest, APoolSharesItsWork) {
  options.components = {throwing("City")};
  options.components[0].policy.scope = {Scope::Kind::pool, 3};
  start(load_and_ask);
  EXPECT_THAT(say({"a", "crash", "b"}),
              ElementsAre(HasSubstr("for a"), HasSubstr("trouble"),
                          HasSubstr("for b")));
  EXPECT_THAT(heard(),
              ElementsAre("failed City: engine trouble 1", "up City Taxi"));
}

// The last of them fails while the others' next try is still to come.
TEST_F(RunningInstancesTest, APoolThatFailsAtOnceIsDownAndTimeGoesOn) {
  options.components = {throwing("City")};
  options.components[0].policy.scope = {Scope::Kind::pool, 5};
  start(load_and_ask);
  say({"crash", "crash", "crash", "crash", "crash"});
  EXPECT_THAT(heard(), testing::Contains("down City: engine trouble"));
  int steps = 0;
  while (node->step_to_next_due(30s) && ++steps < 100) {
  }
  EXPECT_LT(steps, 100);
}

TEST_F(RunningInstancesTest, AnInlineComponentCanBeGivenAMailbox) {
  auto order = inline_component("City", "Taxi", [](const Message& message) {
    return std::vector<Answer>{{"Booked", message.params}};
  });
  order.policy.scope.kind = Scope::Kind::node;
  options.components = {order};
  start(load_and_ask);
  EXPECT_THAT(say({"home"}), ElementsAre("home"));
}

TEST_F(RunningInstancesTest, AnInlineComponentThatThrowsIsCounted) {
  options.components = {inline_component(
      "City", "Taxi", [](const Message&) -> std::vector<Answer> {
        throw std::runtime_error("engine trouble");
      })};
  start(load_and_ask);
  for (int i = 0; i < 5; ++i)
    EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("engine trouble")));
  EXPECT_THAT(heard(), testing::Contains("down City: engine trouble"));
  EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("Offline: ")));
}

// Really a thread that does not come back until the test lets it.
TEST_F(RunningInstancesTest, GivesUpAThreadThatDoesNotReturn) {
  std::mutex mutex;
  std::condition_variable changed;
  bool released = false;
  options.virtual_start.reset();
  options.components = {troubled("City", "wait", [&](auto&, auto&) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return released; });
  })};
  options.components[0].policy.deadline = 300ms;
  start(load_and_ask);
  EXPECT_THAT(say({"wait", "home"}),
              ElementsAre(HasSubstr("within 300 ms"), "City2 for home"));
  {
    std::lock_guard lock(mutex);
    released = true;
  }
  changed.notify_all();
  EXPECT_TRUE(node->stop());
}

// The application does not start, and nobody waits for the thread.
TEST_F(RunningInstancesTest, GivesUpAStartThatDoesNotReturn) {
  std::promise<void> released;
  options.virtual_start.reset();
  options.start_time = 100ms;
  options.drain_time = 100ms;
  options.program = compile("<handler name='Nothing'/>", "", "");
  options.components = {component("City", "Taxi", {})};
  options.components[0].policy.deadline = 50ms;
  options.components[0].factory.create =
      [until = released.get_future().share()]() -> std::unique_ptr<IPlugin> {
    until.wait();
    return nullptr;
  };
  const auto started = Node::start(options);
  EXPECT_EQ(started.error().message,
            "City: a call did not return within 100 ms");
  released.set_value();
}

// -- whether it can take messages ---------------------------------------------

// A company that closes for a second when it is told so. It does not answer
// "wait", and closes a second later.
ComponentOrder closing(const std::string& name) {
  return component(name, "Taxi", [name](auto& self, const Message& message) {
    const auto asked = message.params.at(0).text();
    if (asked == "wait") {
      self.host().after(1s, [&self] { self.host().available(false); });
      return;
    }
    if (asked == "close") {
      self.host().available(false);
      self.host().after(1s, [&self] { self.host().available(true); });
      return;
    }
    self.fire_event("Booked", {name + " for " + asked});
  });
}

constexpr const char* ask_and_tell = R"xml(
  <handler name="News"><messages><component><System>
    <AgentOnline><log param="online {_LPARAM1}"/></AgentOnline>
    <AgentOffline><log param="offline {_LPARAM1}"/></AgentOffline>
  </System></component></messages></handler>)xml";

TEST_F(RunningInstancesTest, ARoleFallsToTheNextWhileOneIsNotAvailable) {
  options.components = {closing("City"), taxi("Country")};
  start(std::string(load_and_ask) + ask_and_tell);
  EXPECT_THAT(say({"home"}), ElementsAre("City for home"));
  EXPECT_THAT(say({"close"}), ElementsAre(HasSubstr("not available")));
  EXPECT_THAT(heard(), ElementsAre("offline City"));
  EXPECT_THAT(say({"home"}), ElementsAre("Country for home"));
  node->advance(1s);
  node->run_until_quiet();
  EXPECT_THAT(heard(), ElementsAre("online City"));
  EXPECT_THAT(say({"home"}), ElementsAre("City for home"));
}

TEST_F(RunningInstancesTest, ARequestEndsWhenItsComponentIsNotAvailable) {
  options.components = {closing("City")};
  start(std::string(load_and_ask) + ask_and_tell);
  EXPECT_THAT(say({"wait"}), testing::IsEmpty());
  node->advance(1s);
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("Refused: City: is not available any more"));
  EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("Offline: ")));
}

// It says so while it starts: nobody hears that it has gone.
TEST_F(RunningInstancesTest, OneMayBeUnavailableFromTheStart) {
  class Away : public IPlugin {
    Expected<void> on_start(const Options&) override {
      host().available(false);
      host().after(1s, [this] { host().available(true); });
      return {};
    }
    void on_message(const Message&) override {
      fire_event("Booked", {"there"});
    }
  };
  auto away = taxi("City");
  away.factory.create = [] { return std::make_unique<Away>(); };
  options.components = {away};
  start(std::string(load_and_ask) + ask_and_tell);
  EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("Offline: ")));
  EXPECT_THAT(heard(), testing::IsEmpty());
  node->advance(1s);
  node->run_until_quiet();
  EXPECT_THAT(heard(), ElementsAre("online City"));
  EXPECT_THAT(say({"home"}), ElementsAre("there"));
}

} // namespace
} // namespace parlour::actors
