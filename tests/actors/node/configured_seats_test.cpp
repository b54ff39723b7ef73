// Seats of the settings: there from the start, with components of their own
// (engine rule 7.7).
#include "actors/node/node.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using testing::Contains;
using testing::Field;

constexpr const char* two_seats =
    R"(<sessions closes-after="1m"/>
       <seat name="desk" opens="Taxi.Honks" closes-after="5s"/>
       <seat name="hall"/>)";

constexpr const char* taxis = R"xml(
  <state name="Here"><Entrance><speak param="Hello."/></Entrance></state>
  <handler name="H"><messages><component>
    <ASR><RecognitionResult>
      <try>
        <request module="Taxi" command="Book" param="_LPARAM1" return="reply"/>
        <speak param="{reply.params[0]}"/>
        <catch name="e"><speak param="{e.kind}"/></catch>
      </try>
    </RecognitionResult></ASR>
    <Taxi><Honks><speak param="It honks."/></Honks></Taxi>
  </component></messages></handler>)xml";

class ConfiguredSeatsTest : public NodeFixture {
protected:
  // Honks a minute after it was booked.
  static ComponentOrder taxi(const std::string& name, const std::string& at) {
    auto order = component(name, "Taxi", [name](auto& self, const Message&) {
      self.fire_event("Booked", {name});
      self.host().after(1min, [&self] {
        Message honks;
        honks.command = "Honks";
        self.host().fire_event(std::move(honks));
      });
    });
    order.policy.seat = at;
    if (!at.empty())
      order.policy.scope.kind = Scope::Kind::seat;
    return order;
  }
  std::vector<std::string> say_at(const SeatId& there,
                                  const std::vector<std::string>& lines) {
    node->enter(there, lines);
    node->run_until_quiet();
    return said();
  }
  // What is said there goes to said(), too.
  SeatId next_seat() {
    open_seat();
    return seat;
  }
};

TEST_F(ConfiguredSeatsTest, AreGivenInTheirOrderAndThenOthers) {
  start(taxis, two_seats, "Here");
  EXPECT_EQ(seat, "desk");
  EXPECT_THAT(node->status(), Contains(Field(&ActorStatus::name, "hall")));
  EXPECT_EQ(next_seat(), "hall");
  EXPECT_EQ(next_seat(), "seat-1");
  EXPECT_EQ(next_seat(), "seat-2");
}

TEST_F(ConfiguredSeatsTest, HaveComponentsThatNobodyElseHas) {
  options.components = {taxi("Ann", "desk"), taxi("Bob", "hall"),
                        taxi("All", "")};
  start(taxis, two_seats);
  EXPECT_THAT(say_at("desk", {"x"}), ElementsAre("Ann"));
  EXPECT_THAT(say_at(next_seat(), {"x"}), ElementsAre("Bob"));
  EXPECT_THAT(say_at(next_seat(), {"x"}), ElementsAre("All"));
}

TEST_F(ConfiguredSeatsTest, WithoutTheirComponentAnotherSeatHasNone) {
  options.components = {taxi("Ann", "desk")};
  start(taxis, two_seats);
  EXPECT_THAT(say_at("desk", {"x"}), ElementsAre("Ann"));
  EXPECT_THAT(say_at(next_seat(), {"x"}), ElementsAre("Offline"));
}

// The conversation that had booked it is over by then.
TEST_F(ConfiguredSeatsTest, OpenForWhatTheirComponentsSay) {
  options.components = {taxi("Ann", "desk"), taxi("Bob", "hall")};
  start(taxis, two_seats, "Here");
  next_seat();
  EXPECT_THAT(say_at("hall", {"x"}), ElementsAre("Hello.", "Bob"));
  EXPECT_THAT(say_at("desk", {"x"}), ElementsAre("Hello.", "Ann"));
  node->end(node->session_at("hall"));
  node->advance(10s);
  EXPECT_EQ(node->session_at("desk"), "");
  EXPECT_EQ(node->session_at("hall"), "");
  said();
  node->advance(51s);
  EXPECT_THAT(said(), ElementsAre("Hello.", "It honks."));
  EXPECT_NE(node->session_at("desk"), "");
  EXPECT_EQ(node->session_at("hall"), "") << "its settings name no event";
  EXPECT_THAT(unhandled,
              Contains(HasSubstr("no conversation is going on at its")));
}

// A component without a seat opens one wherever the event is named.
TEST_F(ConfiguredSeatsTest, OpenForWhatAComponentOfNoSeatSays) {
  options.components = {taxi("All", "")};
  start(taxis, two_seats, "Here");
  Message honks;
  honks.source = "All";
  honks.command = "Honks";
  node->inject("", honks);
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("Hello.", "It honks."));
  EXPECT_NE(node->session_at("desk"), "");
}

// Nothing that the session does with the words is shown before it has said that
// they are private (engine rule 7.6).
TEST_F(ConfiguredSeatsTest, WhatOpensAConversationThereMayBePrivate) {
  class Ear : public IPlugin {
    Expected<void> on_start(const Options&) override {
      host().after(1s, [this] { fire_event("RecognitionResult", {"4711"}); });
      return {};
    }
    void on_message(const Message&) override {}
  };
  auto ear = taxi("Ear", "desk");
  ear.factory.description.roles = {"ASR"};
  ear.factory.create = [] { return std::make_unique<Ear>(); };
  options.components = {ear, answering("Parser", "NLU", "FrameInfo")};
  start(R"xml(
    <var name="pin" expr="''" private="true"/>
    <handler name="H"><messages><component><ASR><RecognitionResult>
      <post module="NLU" command="Parse" param="_LPARAM1"/>
      <set name="pin" expr="_LPARAM1"/>
      <speak param="Thanks."/>
    </RecognitionResult></ASR></component></messages></handler>)xml",
        two_seats);
  node->advance(1s);
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("Thanks."));
  EXPECT_THAT(ways_of("Parse"), ElementsAre(HasSubstr("Parse(***")));
  EXPECT_THAT(ways_of("RecognitionResult"), ElementsAre(HasSubstr("(***")));
}

TEST_F(ConfiguredSeatsTest, CloseAfterTheirOwnTime) {
  start(taxis, two_seats, "Here");
  next_seat();
  node->open("desk");
  node->open("hall");
  node->advance(6s);
  EXPECT_EQ(node->session_at("desk"), "");
  EXPECT_NE(node->session_at("hall"), "");
  node->advance(1min);
  EXPECT_EQ(node->session_at("hall"), "");
}

TEST_F(ConfiguredSeatsTest, AComponentOfASeatThatIsNotThereIsRefused) {
  options.components = {taxi("Ann", "roof")};
  options.program = compile(taxis, two_seats);
  const auto started = Node::start(std::move(options));
  ASSERT_FALSE(started);
  EXPECT_THAT(started.error().message,
              HasSubstr("Ann: there is no seat 'roof' in this run"));
}

} // namespace
} // namespace parlour::actors
