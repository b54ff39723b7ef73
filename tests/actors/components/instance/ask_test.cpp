#include "actors/components/instance/ask.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

// A keyword spotter that asks a database whose number a word is.
ComponentOrder spotter(const std::string& module = "Database") {
  return component(
      "Ear", "KeywordSpotter",
      [module](FunctionPlugin& self, const Message& message) {
        self.ask(module, "Query", {"number of", List{message.params.at(0)}},
                 [&self, message](const Expected<Message>& outcome) {
                   if (!outcome)
                     return self.answer(message, "Keyword",
                                        {to_string(outcome.error())});
                   const auto* rows = outcome->params.at(0).if_result();
                   self.answer(message, "Keyword", {rows->cells.at(0), 1, 0});
                 });
      });
}

ComponentOrder directory() {
  return component("db", "Database", [](auto& self, const Message& message) {
    const auto name = message.params.at(1).at(0).text();
    if (name == "nobody")
      return self.fire_event("Error", {"Refused", "no such person"});
    self.fire_event("Result", {ResultSet{{"number"}, {"number of " + name}}});
  });
}

constexpr const char* ask_ear = R"(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <request module="KeywordSpotter" command="Process" param="_LPARAM1"
        return="heard"/>
      <speak param="{heard.params[0]}"/>
    </RecognitionResult></ASR>
  </component></messages></handler>)";

class AskTest : public NodeFixture {
protected:
  // What the conversation hears of the spotter, and whether somebody waits.
  std::vector<std::string> spot(std::vector<ComponentOrder> components,
                                const std::string& word) {
    options.components = std::move(components);
    start(ask_ear);
    return say({word});
  }
};

TEST_F(AskTest, AKeywordSpotterAsksADatabase) {
  EXPECT_THAT(spot({spotter(), directory()}, "Jeffery"),
              ElementsAre("number of Jeffery"));
  EXPECT_THAT(unhandled, IsEmpty());
  EXPECT_THAT(ways_of("Query"), ElementsAre(HasSubstr("Ear.Query(")));
}

TEST_F(AskTest, HearsWhatIsRefusedWithItsKind) {
  EXPECT_THAT(spot({spotter(), directory()}, "nobody"),
              ElementsAre("db: no such person"));
}

TEST_F(AskTest, HearsThatNobodyIsThere) {
  EXPECT_THAT(spot({spotter()}, "Jeffery"),
              ElementsAre(HasSubstr("role or has the name 'Database'")));
}

TEST_F(AskTest, HearsOfAFailedComponent) {
  auto broken = component("db", "Database", [](auto&, const Message&) {
    throw std::runtime_error("disk gone");
  });
  EXPECT_THAT(spot({spotter(), std::move(broken)}, "Jeffery"),
              ElementsAre("db: disk gone"));
}

TEST_F(AskTest, WaitsForTheEventThatEndsTheRequest) {
  auto telephone =
      component("Phone", "Telephone", [](auto& self, const Message&) {
        self.fire_event("Ringing");
        self.fire_event("Answered", {ResultSet{{"a"}, {"hi"}}});
      });
  EXPECT_THAT(spot({spotter("Telephone"), std::move(telephone)}, "Jeffery"),
              ElementsAre("hi"));
}

// Its description says of Progress that it ends nothing (engine rule 1.3).
TEST_F(AskTest, AnEventOfItsOwnEndsWhatItsDescriptionSays) {
  auto oven = component("Oven", "Robot", [](auto& self, const Message&) {
    self.fire_event("Progress", {50});
    self.fire_event("Baked", {ResultSet{{"cake"}, {"a cake"}}});
  });
  oven.factory.description.events = {{"Progress", "percent"},
                                     {"Baked", "cake", Reply::answer}};
  EXPECT_THAT(spot({spotter("Oven"), std::move(oven)}, "x"),
              ElementsAre("a cake"));
}

TEST_F(AskTest, ARefusalOfItsOwnIsOne) {
  auto oven = component("Oven", "Robot", [](auto& self, const Message&) {
    self.fire_event("Burnt", {"too hot"});
  });
  oven.factory.description.events = {{"Burnt", "why", Reply::refusal}};
  EXPECT_THAT(spot({spotter("Oven"), std::move(oven)}, "x"),
              ElementsAre("Oven: too hot"));
}

// The spotter's own request of ten seconds is over at the same time.
TEST_F(AskTest, GivesUpInTime) {
  std::vector<std::string> told;
  auto silent = component("db", "Database", [](auto&, const Message&) {});
  auto curious =
      component("Ear", "KeywordSpotter", [&](auto& self, const Message&) {
        Message request;
        request.command = "Query";
        request.sinks = {"Database"};
        self.host().ask(request, 3s, [&](const auto& outcome) {
          told.push_back(to_string(outcome.error()));
        });
      });
  EXPECT_THAT(spot({std::move(curious), std::move(silent)}, "x"), IsEmpty());
  node->advance(2999ms);
  EXPECT_THAT(told, IsEmpty());
  node->advance(1ms);
  EXPECT_THAT(told, ElementsAre("Database did not answer Query in time"));
}

// The node comes down while a question is open; nobody is called back.
TEST_F(AskTest, EndsWithItsPlugin) {
  auto silent = component("db", "Database", [](auto&, const Message&) {});
  EXPECT_THAT(spot({spotter(), std::move(silent)}, "Jeffery"), IsEmpty());
  EXPECT_TRUE(node->stop());
  EXPECT_THAT(said(), IsEmpty());
}

TEST_F(AskTest, IsAnsweredInRealTime) {
  options.virtual_start.reset();
  EXPECT_THAT(spot({spotter(), directory()}, "Jeffery"),
              ElementsAre("number of Jeffery"));
}

} // namespace
} // namespace parlour::actors
