#include <algorithm>
#include <list>
#include <stdexcept>

#include "actors/components/placements.hpp"
#include "tests/actors/plugin_shelf.hpp"

namespace parlour::actors {
namespace {

// A company that knows how many have asked this very instance, and how many
// instances there are.
struct Fleet {
  std::atomic<int> alive = 0;
  std::atomic<int> made = 0;
};

class CountingTaxi : public IPlugin {
public:
  CountingTaxi(std::shared_ptr<Fleet> fleet, std::string name)
      : fleet_(std::move(fleet)), name_(std::move(name)) {
    ++fleet_->alive;
    ++fleet_->made;
  }
  ~CountingTaxi() override {
    --fleet_->alive;
  }

protected:
  void on_message(const Message& message) override {
    const auto asked = message.params.at(0).text();
    if (asked == "crash")
      throw std::runtime_error("engine trouble");
    if (asked == "flood")
      for (int i = 0; i < 10'000; ++i)
        host().fire_event(by_itself("Noise", {}));
    if (asked == "remind")
      host().after(
          1s, [this] { host().fire_event(by_itself("Reminder", {count_})); });
    if (asked == "never")
      return;
    fire_event("Booked", {name_ + std::to_string(++count_) + " " + asked});
  }

private:
  static Message by_itself(const char* command, std::vector<Value> params) {
    Message message;
    message.command = command;
    message.params = std::move(params);
    return message;
  }

  std::shared_ptr<Fleet> fleet_;
  std::string name_;
  int count_ = 0;
};

constexpr const char* reminded = R"xml(
  <handler name="Reminded"><messages><component><Taxi>
    <Reminder><speak param="Reminder {_LPARAM1}."/></Reminder>
  </Taxi></component></messages></handler>)xml";

class PlacementsTest : public LoadingTest {
protected:
  struct Desk {
    SeatId seat;
    std::vector<std::string> said;
  };

  ComponentOrder city(Scope::Kind scope, const std::string& speaks_as = "") {
    auto order = taxi("City");
    order.policy.scope.kind = scope;
    order.factory.create = [fleet = fleet, speaks_as] {
      return std::make_unique<CountingTaxi>(fleet, speaks_as);
    };
    return order;
  }

  void start_with(std::vector<ComponentOrder> components) {
    options.components = std::move(components);
    start(std::string(load_and_ask) + reminded,
          R"(<sessions closes-after="1h"/>)");
  }

  Desk& desk() {
    auto& made = desks_.emplace_back();
    made.seat =
        node->open_seat({[&made](const auto&, const dialogue::Output& output) {
                           made.said.push_back(output.text);
                         },
                         {}});
    return made;
  }

  std::vector<std::string> ask(Desk& desk, const std::string& what) {
    node->enter(desk.seat, {what});
    node->run_until_quiet();
    return std::exchange(desk.said, {});
  }

  void end(Desk& desk) {
    node->end(node->session_at(desk.seat));
    node->run_until_quiet();
  }

  std::shared_ptr<Fleet> fleet = std::make_shared<Fleet>();

private:
  std::list<Desk> desks_;
};

TEST_F(PlacementsTest, EachSessionHasItsOwnAndNobodyElses) {
  start_with({city(Scope::Kind::session)});
  std::vector<Desk*> all;
  for (int i = 0; i < 50; ++i)
    all.push_back(&desk());
  EXPECT_EQ(fleet->made, 0);
  for (int round = 1; round <= 3; ++round) {
    for (auto* one : all)
      node->enter(one->seat, {one->seat});
    node->run_until_quiet();
    for (auto* one : all)
      EXPECT_THAT(std::exchange(one->said, {}),
                  ElementsAre(std::to_string(round) + " " + one->seat));
  }
  EXPECT_EQ(fleet->alive, 50);
  EXPECT_EQ(fleet->made, 50);
}

// The same by threads.
TEST_F(PlacementsTest, EachSessionHasItsOwnInRealTime) {
  options.virtual_start.reset();
  start_with({city(Scope::Kind::session)});
  std::vector<Desk*> all;
  for (int i = 0; i < 20; ++i)
    all.push_back(&desk());
  for (auto* one : all)
    node->enter(one->seat, {"a", one == all[7] ? "crash" : "b", "c"});
  node->run_until_quiet();
  for (auto* one : all)
    EXPECT_THAT(
        one->said,
        ElementsAre("1 a",
                    one == all[7] ? "Refused: City: engine trouble" : "2 b",
                    one == all[7] ? "1 c" : "3 c"));
  for (auto* one : all)
    node->end(node->session_at(one->seat));
  EXPECT_TRUE(node->stop());
  EXPECT_EQ(fleet->alive, 0);
}

TEST_F(PlacementsTest, ComesAndGoesWithItsSession) {
  start_with({city(Scope::Kind::session)});
  auto& one = desk();
  auto& other = desk();
  node->open(one.seat);
  EXPECT_EQ(fleet->alive, 1); // before anything is said
  ask(other, "home");
  EXPECT_EQ(fleet->alive, 2);
  end(one);
  EXPECT_EQ(fleet->alive, 1);
  EXPECT_THAT(ask(other, "home"), ElementsAre("2 home"));
  EXPECT_THAT(ask(one, "home"), ElementsAre("1 home")); // its next session
  EXPECT_THAT(logs, IsEmpty());
}

TEST_F(PlacementsTest, WhatItWasGivenAtTheEndItStillDoes) {
  options.components = {city(Scope::Kind::session)};
  start(R"(
    <state name="Main">
      <Exit><post module="Taxi" command="Book" param="'home'"/></Exit>
    </state>
    <handler name="Pipeline"><messages><component>
      <ASR><RecognitionResult><end/></RecognitionResult></ASR>
    </component></messages></handler>)",
        "", "Main");
  say({"bye"});
  EXPECT_EQ(over, 1);
  EXPECT_THAT(ways_of("Booked"), ElementsAre(HasSubstr("1 home")));
  EXPECT_EQ(fleet->alive, 0);
}

TEST_F(PlacementsTest, OneThatBreaksIsItsSessionsAlone) {
  start_with({city(Scope::Kind::session)});
  auto& one = desk();
  auto& other = desk();
  for (auto* each : {&one, &other})
    EXPECT_THAT(ask(*each, "home"), ElementsAre("1 home"));
  for (const auto* trouble : {"crash", "flood"}) {
    EXPECT_THAT(ask(one, trouble), ElementsAre(HasSubstr("Refused: City: ")));
    node->advance(1s);
    EXPECT_THAT(heard(), ElementsAre(HasSubstr("failed City: "),
                                     "up City Taxi")); // one session's
    EXPECT_THAT(ask(one, "home"), ElementsAre("1 home"));
  }
  EXPECT_THAT(ask(other, "home"), ElementsAre("2 home"));
  EXPECT_EQ(fleet->alive, 2);
}

TEST_F(PlacementsTest, AHangIsItsSessionsAlone) {
  auto order = city(Scope::Kind::session);
  order.policy.deadline = 1s;
  order.factory.create = [this, create = order.factory.create] {
    return std::make_unique<FunctionPlugin>(
        [this, inner = std::shared_ptr<IPlugin>(create()),
         begun = false](FunctionPlugin& self, const Message& what) mutable {
          if (!std::exchange(begun, true)) {
            EXPECT_TRUE(inner->start(self.host(), {}));
          }
          if (what.params.at(0) == Value("wait")) {
            node->advance(1s);
            node->run_until_quiet();
          }
          inner->receive(what);
        });
  };
  start_with({order});
  auto& one = desk();
  auto& other = desk();
  ask(one, "home");
  ask(other, "home");
  EXPECT_THAT(ask(one, "wait"), ElementsAre(HasSubstr("within 1000 ms")));
  EXPECT_THAT(ask(one, "home"), ElementsAre("1 home"));
  EXPECT_THAT(ask(other, "home"), ElementsAre("2 home"));
}

TEST_F(PlacementsTest, ARoleFallsToTheNextForItsSessionAlone) {
  start_with({city(Scope::Kind::session), taxi("Country")});
  auto& one = desk();
  auto& other = desk();
  for (int i = 0; i < 5; ++i) {
    EXPECT_THAT(ask(one, "crash"), ElementsAre(HasSubstr("engine trouble")));
    node->advance(1s);
  }
  EXPECT_THAT(heard(), testing::Contains("down City: engine trouble"));
  EXPECT_THAT(ask(one, "home"), ElementsAre("Country for home"));
  EXPECT_THAT(ask(other, "home"), ElementsAre("1 home"));
  node->advance(1min);
  node->run_until_quiet();
  EXPECT_THAT(ask(one, "home"), ElementsAre("1 home"));
}

TEST_F(PlacementsTest, WhatItSaysByItselfIsItsSessions) {
  start_with({city(Scope::Kind::session)});
  auto& one = desk();
  auto& other = desk();
  ask(other, "home");
  ask(one, "remind");
  node->advance(2s);
  EXPECT_THAT(one.said, ElementsAre("Reminder 1."));
  EXPECT_THAT(other.said, IsEmpty());
}

// A message of no session is none's to answer.
TEST_F(PlacementsTest, AMessageWithoutASessionFindsNoInstance) {
  start_with({city(Scope::Kind::session)});
  node->open(seat);
  Message message;
  message.source = "Script";
  message.command = "Book";
  message.sinks = {"Taxi"};
  node->inject("", message);
  node->run_until_quiet();
  EXPECT_THAT(unhandled, ElementsAre("nobody is there for Taxi"));
}

TEST_F(PlacementsTest, EachSeatHasItsOwnForAllItsSessions) {
  start_with({city(Scope::Kind::seat)});
  node->run_until_quiet();
  EXPECT_EQ(fleet->alive, 1); // the fixture's seat's
  auto& one = desk();
  auto& other = desk();
  node->run_until_quiet();
  EXPECT_EQ(fleet->alive, 3);
  EXPECT_THAT(ask(one, "home"), ElementsAre("1 home"));
  end(one);
  EXPECT_THAT(ask(one, "home"), ElementsAre("2 home"));
  EXPECT_THAT(ask(other, "home"), ElementsAre("1 home"));
  EXPECT_EQ(fleet->made, 3);
}

// It speaks for the session that is there; a turn opens one where there is
// none.
// A microphone is heard by the detector of its seat while nobody talks.
TEST_F(PlacementsTest, ASeatsComponentsHearEachOtherBetweenSessions) {
  start_with({city(Scope::Kind::seat)});
  auto& first = desk();
  auto& second = desk();
  ask(first, "one");
  end(first);
  Message message;
  message.command = "Book";
  message.params = {"unasked"};
  message.sinks = {"City"};
  for (const auto& place : {first.seat, second.seat, first.seat})
    node->inject(place, message);
  node->run_until_quiet();
  EXPECT_THAT(ask(first, "two"), ElementsAre("4 two"));
  EXPECT_THAT(ask(second, "two"), ElementsAre("2 two"));
}

TEST_F(PlacementsTest, ASeatsComponentOpensItsSession) {
  auto ear = component("Ear", "ASR", [](auto& self, const Message& message) {
    Message heard;
    heard.command = message.params.at(0).text();
    heard.params = {"home", 1};
    self.host().fire_event(heard);
  });
  ear.policy.scope.kind = Scope::Kind::seat;
  std::vector<IPlugin*> ears;
  ear.factory.create = [&ears, create = ear.factory.create] {
    auto made = create();
    ears.push_back(made.get());
    return made;
  };
  start_with({ear, city(Scope::Kind::session)});
  auto& one = desk();
  node->run_until_quiet();
  ASSERT_EQ(ears.size(), 2u);
  auto hears = [&](const char* command) {
    Message message;
    message.params = {command};
    ears.back()->receive(message);
    node->run_until_quiet();
    return std::exchange(one.said, {});
  };
  EXPECT_THAT(hears("Hiccup"), IsEmpty());
  EXPECT_THAT(unhandled, ElementsAre(HasSubstr("no conversation is going")));
  EXPECT_THAT(hears("RecognitionResult"), ElementsAre("1 home"));
  EXPECT_THAT(hears("RecognitionResult"), ElementsAre("2 home"));
  end(one);
  EXPECT_THAT(hears("RecognitionResult"), ElementsAre("1 home"));
  EXPECT_THAT(said(), IsEmpty()); // at the other seat
}

TEST_F(PlacementsTest, ReplacingReachesEachAndLosesNothing) {
  start_with({city(Scope::Kind::session, "old ")});
  shelf->put(city(Scope::Kind::session, "new "));
  auto& one = desk();
  auto& other = desk();
  EXPECT_THAT(ask(one, "home"), ElementsAre("old 1 home"));
  EXPECT_THAT(ask(other, "home"), ElementsAre("old 1 home"));
  EXPECT_THAT(ask(one, "load City as City"), ElementsAre("City is up."));
  EXPECT_EQ(fleet->alive, 2);
  EXPECT_THAT(ask(one, "home"), ElementsAre("new 1 home"));
  EXPECT_THAT(ask(other, "home"), ElementsAre("new 1 home"));
  EXPECT_THAT(ask(desk(), "home"), ElementsAre("new 1 home"));
}

TEST_F(PlacementsTest, UnloadingReachesEachAndLoadingGivesEachItsOwn) {
  start_with({city(Scope::Kind::session)});
  shelf->put(city(Scope::Kind::session));
  auto& one = desk();
  auto& other = desk();
  ask(other, "home");
  EXPECT_THAT(ask(one, "unload City"), ElementsAre("City is gone."));
  EXPECT_EQ(fleet->alive, 0);
  EXPECT_THAT(ask(other, "home"), ElementsAre(HasSubstr("Offline: ")));
  EXPECT_THAT(ask(one, "load City as City"), ElementsAre("City is up."));
  EXPECT_EQ(fleet->alive, 2);
  for (auto* each : {&one, &other})
    EXPECT_THAT(ask(*each, "home"), ElementsAre("1 home"));
}

// A hundred replacements under load, by threads, while sessions come and go:
// each question is answered by a company or by an error, and nothing is left.
TEST_F(PlacementsTest, AHundredTimesUnderLoad) {
  options.virtual_start.reset();
  start_with({city(Scope::Kind::session)});
  shelf->put(city(Scope::Kind::session));
  auto& one = desk();
  auto& other = desk();
  for (int i = 0; i < 100; ++i) {
    node->enter(one.seat, {"one", "two"});
    node->enter(seat, {"load City as City"});
    node->enter(other.seat, {"three"});
    node->run_until_quiet();
    end(other);
  }
  EXPECT_EQ(one.said.size(), 200u);
  EXPECT_THAT(one.said, testing::Each(testing::Not(HasSubstr("Timeout"))));
  EXPECT_EQ(other.said.size(), 100u);
  EXPECT_EQ(std::ranges::count(said(), "City is up."), 100);
  EXPECT_TRUE(node->stop());
  EXPECT_EQ(fleet->alive, 0);
}

TEST_F(PlacementsTest, HasNoMoreInstancesThanItMay) {
  start_with({city(Scope::Kind::session), taxi("Country")});
  for (std::size_t i = 0; i < Placements::max_services; ++i)
    node->open(desk().seat);
  auto& late = desk();
  EXPECT_THAT(ask(late, "home"), ElementsAre("Country for home"));
  EXPECT_THAT(heard(), ElementsAre("down City: has 1000 instances, as many as "
                                   "it may have"));
  EXPECT_EQ(fleet->alive, 1'000);
}

} // namespace
} // namespace parlour::actors
