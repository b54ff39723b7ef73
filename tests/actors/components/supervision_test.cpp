#include <fstream>
#include <iterator>
#include <stdexcept>

#include "actors/components/supervision.hpp"
#include "tests/actors/plugin_shelf.hpp"
#include "tests/support/paths.hpp"

namespace parlour::actors {
namespace {

using SupervisionTest = LoadingTest;

// Answers by its option.
class Named : public IPlugin {
  Expected<void> on_start(const Options& options) override {
    name_ = options.count("name") ? options.at("name") : "nobody";
    return {};
  }
  void on_message(const Message&) override {
    fire_event("Booked", {name_});
  }
  std::string name_;
};

ComponentOrder named_city() {
  auto city = taxi("City");
  city.factory.create = [] { return std::make_unique<Named>(); };
  return city;
}

TEST_F(SupervisionTest, LoadsAndUnloadsByName) {
  shelf->put(taxi("City"));
  start(load_and_ask);
  EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("Offline: ")));
  EXPECT_THAT(say({"load City as Company"}), ElementsAre("Company is up."));
  EXPECT_THAT(say({"home"}), ElementsAre("City for home"));
  EXPECT_THAT(say({"unload Company"}), ElementsAre("Company is gone."));
  EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("Offline: ")));
  EXPECT_THAT(heard(),
              ElementsAre("up Company Taxi", "down Company: unloaded"));
}

TEST_F(SupervisionTest, SaysWhyItDoesNotLoad) {
  class Broken : public IPlugin {
    Expected<void> on_start(const Options&) override {
      return fail(ErrorKind::settings, "there is no such device");
    }
    void on_message(const Message&) override {}
  };
  auto broken = taxi("Broken");
  broken.factory.create = [] { return std::make_unique<Broken>(); };
  auto wanting = taxi("Wanting");
  wanting.factory.description.options = {{"file", "", "where it is", true}};
  auto unmade = taxi("Unmade");
  unmade.factory.create = [] { return nullptr; };
  for (const auto& order : {broken, wanting, unmade})
    shelf->put(order);
  start(load_and_ask);
  EXPECT_THAT(say({"load Missing as X"}),
              ElementsAre("Settings: there is no plug-in 'Missing'"));
  EXPECT_THAT(say({"load Broken as X"}),
              ElementsAre("Settings: there is no such device"));
  EXPECT_THAT(say({"load Wanting as X"}),
              ElementsAre("Settings: X: the option 'file' is missing: where it "
                          "is"));
  EXPECT_THAT(say({"load Unmade as X"}),
              ElementsAre("Settings: was not made: its factory gave none"));
  EXPECT_THAT(say({"unload Misssing"}),
              ElementsAre("Offline: there is no component 'Misssing'"));
  EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("Offline: ")));
}

TEST_F(SupervisionTest, SaysWhatAScopeIsNotFor) {
  auto city = taxi("City");
  city.policy.scope.kind = Scope::Kind::in_turn;
  auto shelf_of_books = component("Shelf", "Database", [](auto&, auto&) {});
  shelf_of_books.policy.scope = {Scope::Kind::pool, 2};
  for (const auto& [order, why] :
       std::vector<std::pair<ComponentOrder, const char*>>{
           {city, "has a state of its own"},
           {shelf_of_books, "not for a database"}}) {
    NodeOptions wanted;
    wanted.virtual_start = nine_o_clock;
    wanted.program = compile(echo);
    wanted.components = {order};
    const auto started = Node::start(std::move(wanted));
    ASSERT_FALSE(started) << why;
    EXPECT_THAT(started.error().message, HasSubstr(why));
  }
}

TEST_F(SupervisionTest, OneTakesThePlaceOfAnother) {
  options.components = {taxi("City"), taxi("Country")};
  shelf->put(taxi("Luxury"));
  start(load_and_ask);
  EXPECT_THAT(say({"load Luxury as City"}), ElementsAre("City is up."));
  EXPECT_THAT(say({"home"}), ElementsAre("Luxury for home"));
  EXPECT_THAT(heard(), ElementsAre("up City Taxi"));
}

TEST_F(SupervisionTest, NobodyTakesThePlaceOfAnotherRole) {
  options.components = {taxi("City")};
  shelf->put(component("Desk", "Telephone", [](auto&, auto&) {}));
  auto spy = taxi("Spy");
  spy.factory.description.roles.push_back("System");
  shelf->put(spy);
  start(load_and_ask);
  EXPECT_THAT(say({"load Desk as City"}),
              ElementsAre("Settings: City: it is the Taxi here, which Desk is "
                          "not; load Desk under another name"));
  EXPECT_THAT(say({"home"}), ElementsAre("City for home"));
  for (const auto* name : {"System", "ASR", "Record"})
    EXPECT_THAT(say({std::string("load Desk as ") + name}),
                ElementsAre(HasSubstr("choose another name")));
  EXPECT_THAT(say({"load Spy as Spy"}),
              ElementsAre(HasSubstr("a source of the platform's own")));
  EXPECT_THAT(heard(), IsEmpty());
}

TEST_F(SupervisionTest, WhatIsLoadedAgainHasItsOptions) {
  auto city = named_city();
  shelf->put(city);
  city.options = {{"name", "Ada"}};
  options.components = {city};
  start(load_and_ask);
  EXPECT_THAT(say({"load City as City", "home"}),
              ElementsAre("City is up.", "Ada"));
  EXPECT_THAT(say({"unload City", "load City as City", "home"}),
              ElementsAre("City is gone.", "City is up.", "Ada"));
  EXPECT_THAT(say({"unload City", "load City as Other", "home"}),
              ElementsAre("City is gone.", "Other is up.", "nobody"));
}

// It stands in the settings for scripts alone, under a name of its own.
TEST_F(SupervisionTest, WhatIsForScriptsHasItsOptionsWhenItIsLoaded) {
  auto city = named_city();
  shelf->put(city);
  city.name = "Spare";
  city.options = {{"name", "Ada"}};
  city.policy.scope = {Scope::Kind::usual, 0};
  options.components = {city};
  options.complete = [](ComponentOrder& order) {
    order.options["name"] += " of " + order.name;
  };
  start(load_and_ask);
  EXPECT_THAT(say({"home"}), ElementsAre(HasSubstr("Offline: ")));
  EXPECT_THAT(say({"load City as Spare", "home"}),
              ElementsAre("Spare is up.", "Ada of Spare"));
}

TEST_F(SupervisionTest, WhatDoesNotStartTakesNobodysPlace) {
  auto unmade = taxi("Unmade");
  unmade.factory.create = [] { return nullptr; };
  shelf->put(unmade);
  options.components = {taxi("City")};
  start(load_and_ask);
  EXPECT_THAT(say({"load Unmade as City"}), ElementsAre(HasSubstr("not made")));
  EXPECT_THAT(say({"home"}), ElementsAre("City for home"));
}

// What docs/components.md shows: a recycled voice, for as long as the voice is
// down.
TEST_F(SupervisionTest, TheExampleOfItsPageWorks) {
  std::ifstream page(test::source_path("docs/components.md"));
  const std::string text(std::istreambuf_iterator<char>(page), {});
  const auto begin = text.find("<handler name=\"Voices\">");
  const auto end = text.find("```", begin);
  ASSERT_NE(end, std::string::npos);
  std::vector<std::string> spoken;
  auto fails = std::make_shared<bool>(true);
  auto voice = [&](const char* name, std::shared_ptr<bool> broken) {
    return component(name, "TTS", [&, name, broken](auto&, const Message& it) {
      if (*broken)
        throw std::runtime_error("hoarse");
      spoken.push_back(name + (": " + it.params.at(0).text()));
    });
  };
  options.components = {voice("Voice", fails)};
  shelf->put(voice("TextFileTTS", std::make_shared<bool>(false)));
  start(text.substr(begin, end - begin) + R"(
    <handler name="Pipeline"><messages><component>
      <ASR><RecognitionResult>
        <post module="TTS" command="Speak" param="_LPARAM1"/>
      </RecognitionResult></ASR>
    </component></messages></handler>)",
        R"(<sessions closes-after="1h"/>)");
  for (int i = 0; i < 5; ++i) {
    say({"one"});
    node->advance(1s);
  }
  say({"two"});
  *fails = false;
  node->advance(1min);
  node->run_until_quiet();
  say({"three"});
  EXPECT_THAT(spoken, ElementsAre("TextFileTTS: two", "Voice: three"));
  EXPECT_FALSE(node->unload("Spare"));
}

// A hundred comings and goings while others ask: each question is answered, by
// a company or by an error, and nothing is left.
TEST_F(SupervisionTest, AHundredTimesUnderLoad) {
  auto alive = std::make_shared<std::atomic<int>>(0);
  auto company = taxi("City");
  company.factory.create = [alive] {
    ++*alive;
    std::shared_ptr<void> retired(nullptr, [alive](void*) { --*alive; });
    return std::make_unique<FunctionPlugin>(
        [retired](FunctionPlugin& self, const Message& message) {
          self.fire_event("Booked", message.params);
        });
  };
  for (const bool virtual_time : {true, false}) {
    options = {};
    options.plugins = shelf;
    if (virtual_time)
      options.virtual_start = nine_o_clock;
    shelf->put(company);
    start(load_and_ask);
    std::atomic<int> answers = 0;
    SeatCallbacks calls;
    calls.on_output = [&](const auto&, const auto&) { ++answers; };
    const auto other = node->open_seat(std::move(calls));
    for (int i = 0; i < 100; ++i) {
      node->enter(other, {"one", "two"});
      node->enter(seat, {"load City as Company"});
      node->enter(other, {"three", "four"});
      node->enter(seat, {i % 2 ? "unload Company" : "load City as Company"});
      node->run_until_quiet();
    }
    EXPECT_EQ(answers, 400);
    EXPECT_EQ(said().size(), 200u);
    node.reset();
    EXPECT_EQ(*alive, 0);
  }
}

} // namespace
} // namespace parlour::actors
