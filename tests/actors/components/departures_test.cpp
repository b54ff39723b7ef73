#include "actors/components/departures.hpp"
#include "tests/actors/plugin_shelf.hpp"

namespace parlour::actors {
namespace {

using DeparturesTest = LoadingTest;

// What the old one has begun it ends, if that takes no more than 2 s.
TEST_F(DeparturesTest, TheOldOneStillAnswersWhatItOwes) {
  for (const auto& [delay, answer] :
       std::vector<std::pair<Milliseconds, const char*>>{
           {1500ms, "old"}, {2500ms, "Refused: City: it was stopped"}}) {
    options = {};
    options.virtual_start = nine_o_clock;
    options.plugins = shelf;
    options.components = {component(
        "City", "Taxi", [delay = delay](auto& self, const Message& message) {
          self.host().after(delay, [&self, message] {
            self.answer(message, "Booked", {"old"});
          });
        })};
    shelf->put(taxi("Luxury"));
    start(load_and_ask);
    EXPECT_THAT(say({"home"}), IsEmpty());
    auto other = node->open_seat({[](const auto&, const auto&) {}, {}});
    node->enter(other, {"load Luxury as City"});
    node->run_until_quiet();
    EXPECT_THAT(said(), IsEmpty());
    node->advance(3s);
    EXPECT_THAT(said(), ElementsAre(answer));
  }
}

// What comes meanwhile waits for that: nothing is answered out of turn.
TEST_F(DeparturesTest, TheNewOneBeginsWhenTheOldOneHasFinished) {
  options.components = {
      component("City", "Taxi", [](auto& self, const Message& message) {
        self.host().after(1500ms, [&self, message] {
          self.answer(message, "Booked", {"old"});
        });
      })};
  shelf->put(taxi("Luxury"));
  start(load_and_ask);
  EXPECT_THAT(say({"home"}), IsEmpty());
  std::vector<std::string> others;
  const auto other = node->open_seat(
      {[&](const auto&, const auto& output) { others.push_back(output.text); },
       {}});
  node->enter(other, {"load Luxury as City", "work"});
  node->run_until_quiet();
  EXPECT_THAT(others, ElementsAre("City is up."));
  node->advance(1500ms);
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("old"));
  EXPECT_THAT(others, ElementsAre("City is up.", "Luxury for work"));
}

// It speaks of itself only: what waits in the mailbox is the new one's, which
// serves.
TEST_F(DeparturesTest, TheOldOneMayBecomeUnavailable) {
  options.components = {
      component("City", "Taxi", [](auto& self, const Message&) {
        self.host().after(1s, [&self] { self.host().available(false); });
      })};
  shelf->put(taxi("Luxury"));
  start(std::string(load_and_ask) + R"xml(
    <handler name="News"><messages><component><System>
      <AgentOffline><log param="offline {_LPARAM1}"/></AgentOffline>
    </System></component></messages></handler>)xml");
  EXPECT_THAT(say({"home"}), IsEmpty());
  std::vector<std::string> others;
  const auto other = node->open_seat(
      {[&](const auto&, const auto& output) { others.push_back(output.text); },
       {}});
  node->enter(other, {"load Luxury as City", "work"});
  node->run_until_quiet();
  heard();
  node->advance(1s);
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("Refused: City: is not available any more"));
  EXPECT_THAT(others, ElementsAre("City is up.", "Luxury for work"));
  EXPECT_THAT(heard(), IsEmpty());
}

TEST_F(DeparturesTest, AnUnloadedOneStillDoesWhatWaits) {
  options.components = {taxi("City")};
  start(load_and_ask);
  node->open(seat);
  auto message = [](const char* what) {
    Message made;
    made.source = "Script";
    made.command = "Book";
    made.params = {what};
    made.sinks = {"Taxi"};
    return made;
  };
  for (int i = 0; i < 100; ++i)
    node->inject("", message("go"));
  say({"unload City"});
  EXPECT_EQ(ways_of("Booked").size(), 100u);
}

} // namespace
} // namespace parlour::actors
