#include "actors/routing/routing_table.hpp"
#include "tests/actors/node_fixture.hpp"
#include "tests/support/manual_clock.hpp"

namespace parlour::actors {
namespace {

class RoutingTableTest : public testing::Test {
protected:
  void make(const std::string& routes) {
    RoutingTable::Parts parts;
    parts.program = compile(std::string(echo) + routes);
    parts.aliases = {{"Record", "Microphone"}};
    parts.clock = &clock;
    parts.counters = std::make_shared<Counters>();
    parts.taps.push_back(
        [this](const Message& message, const std::string& way) {
          taps.push_back(message.command + " " + way);
        });
    parts.complain = [this](const Message& message, const Error& error) {
      complaints.push_back(message.command + ": " + to_string(error));
    };
    for (auto& [name, role] : std::vector<std::pair<std::string, std::string>>{
             {"Mic", "Microphone"}, {"Fast", "ASR"}, {"Good", "ASR"}}) {
      up.push_back(std::make_shared<std::atomic<bool>>(true));
      parts.targets.push_back({name, {role}, {}, nullptr, up.back()});
      parts.targets.back().events = {{"Noise", "level", Reply::none}};
    }
    table = std::make_unique<RoutingTable>(std::move(parts));
  }

  static Message event(std::string source, std::string command,
                       std::vector<Value> params = {}) {
    Message message;
    message.source = std::move(source);
    message.command = std::move(command);
    message.params = std::move(params);
    message.session = "s1";
    return message;
  }

  static std::vector<std::string> delivered(const Routed& routed) {
    std::vector<std::string> result;
    for (const auto& delivery : routed.deliveries)
      result.push_back(delivery.target->name + ": " +
                       to_string(*delivery.message));
    return result;
  }

  static std::vector<std::string> unreached(const Routed& routed) {
    std::vector<std::string> sinks;
    for (const auto& missed : routed.unreached)
      sinks.push_back(missed.sink);
    return sinks;
  }

  test::ManualClock clock;
  std::vector<std::shared_ptr<std::atomic<bool>>> up;
  std::vector<std::string> taps;
  std::vector<std::string> complaints;
  std::unique_ptr<RoutingTable> table;
};

TEST_F(RoutingTableTest, StampsInOrder) {
  make("");
  auto first = table->route(event("Mic", "Started"));
  auto second = table->route(event("Mic", "Started"));
  EXPECT_EQ(first.for_session->number, 1u);
  EXPECT_EQ(second.for_session->number, 2u);
  EXPECT_EQ(second.for_session->time, clock.now());
  EXPECT_EQ(table->counters().messages(), 2u);
}

TEST_F(RoutingTableTest, GivesASinkToTheFirstThatIsUp) {
  make("");
  auto message = event("Script", "DoRecognition");
  message.sinks = {"ASR"};
  EXPECT_THAT(delivered(table->route(message)),
              ElementsAre(HasSubstr("Fast: Script.DoRecognition")));
  *up[1] = false;
  EXPECT_THAT(delivered(table->route(message)),
              ElementsAre(HasSubstr("Good: Script.DoRecognition")));
  message.sinks = {"Fast"};
  auto routed = table->route(message);
  EXPECT_THAT(routed.deliveries, IsEmpty());
  EXPECT_THAT(unreached(routed), ElementsAre("Fast"));
  EXPECT_EQ(table->counters().unhandled, 0u); // its sender counts
}

TEST_F(RoutingTableTest, GivesAStarToAllThatAreUp) {
  make(R"(<routes><relay source="Record" command="BufferFull" to="ASR*"/>
          </routes>)");
  EXPECT_THAT(delivered(table->route(event("Mic", "BufferFull"))),
              ElementsAre(HasSubstr("Fast: Mic.BufferFull"),
                          HasSubstr("Good: Mic.BufferFull")));
  auto message = event("Script", "DoRecognition");
  message.sinks = {"ASR*"};
  *up[1] = false;
  EXPECT_THAT(delivered(table->route(message)),
              ElementsAre(HasSubstr("Good: Script.DoRecognition")));
  EXPECT_EQ(table->find("ASR*", "")->name, "Good");
  *up[2] = false;
  EXPECT_THAT(unreached(table->route(message)), ElementsAre("ASR*"));
  EXPECT_EQ(table->find("ASR*", ""), nullptr);
  message.sinks = {"Record*"}; // an alias
  EXPECT_THAT(delivered(table->route(message)), ElementsAre(HasSubstr("Mic")));
}

TEST_F(RoutingTableTest, KnowsAUsersTurn) {
  make("");
  EXPECT_TRUE(table->begins_turn(event("Good", "RecognitionResult")));
  EXPECT_FALSE(table->begins_turn(event("Mic", "RecognitionResult")));
  EXPECT_FALSE(table->begins_turn(event("Good", "Partial")));
}

TEST_F(RoutingTableTest, KnowsWhatOpensAConversation) {
  make(R"(<routes><open source="Record" command="Loud" if="_LPARAM1 gt 3"
          seat="lobby"/><open source="Good" command="*"/></routes>)");
  EXPECT_TRUE(table->opens(event("Mic", "Loud", {4}), "lobby"));
  EXPECT_FALSE(table->opens(event("Mic", "Loud", {3}), "lobby"));
  EXPECT_FALSE(table->opens(event("Mic", "Loud", {4}), "desk"));
  EXPECT_FALSE(table->opens(event("Mic", "Quiet", {4}), "lobby"));
  EXPECT_TRUE(table->opens(event("Good", "Partial"), "desk"));
  EXPECT_TRUE(table->route(event("Good", "Partial")).for_session);
  EXPECT_EQ(table->counters().relayed, 0u);
}

TEST_F(RoutingTableTest, RelaysACopyAndGoesOn) {
  make(R"(<routes><relay source="Record" command="BufferFull" to="ASR, Good"
          as="DoRecognition"/></routes>)");
  auto routed = table->route(event("Mic", "BufferFull", {1}));
  EXPECT_THAT(delivered(routed),
              ElementsAre(HasSubstr("Fast: Mic.DoRecognition(1)"),
                          HasSubstr("Good: Mic.DoRecognition(1)")));
  ASSERT_TRUE(routed.for_session);
  EXPECT_EQ(routed.for_session->command, "BufferFull");
  EXPECT_EQ(table->counters().relayed, 1u);
  EXPECT_THAT(taps,
              ElementsAre("DoRecognition relay -> ASR",
                          "DoRecognition relay -> Good", "BufferFull session"));
}

TEST_F(RoutingTableTest, AFilterThatHoldsEndsTheWay) {
  make(R"(<routes><filter source="ASR" command="RecognitionResult"
          if="_LPARAM2 lt 0.3" to="Mic" as="Reprompt"/></routes>)");
  auto low = table->route(event("Fast", "RecognitionResult", {"x", 0.2}));
  EXPECT_THAT(delivered(low), ElementsAre(HasSubstr("Mic: Fast.Reprompt")));
  EXPECT_FALSE(low.for_session);
  auto high = table->route(event("Fast", "RecognitionResult", {"x", 0.9}));
  EXPECT_THAT(delivered(high), IsEmpty());
  EXPECT_TRUE(high.for_session);
  EXPECT_EQ(table->counters().filtered, 1u);
}

TEST_F(RoutingTableTest, ConditionsAndParametersSeeConstants) {
  make(R"(<var name="broken" expr="1 / 0"/><const name="half" expr="0.5"/>
          <const name="least" expr="half - 0.2"/>
          <routes><filter source="ASR" command="RecognitionResult"
          if="_LPARAM2 lt least" to="Mic" as="Reprompt" param="{least}"/>
          </routes>)");
  auto low = table->route(event("Fast", "RecognitionResult", {"x", 0.2}));
  EXPECT_THAT(delivered(low),
              ElementsAre(HasSubstr("Mic: Fast.Reprompt(0.3)")));
  auto high = table->route(event("Fast", "RecognitionResult", {"x", 0.9}));
  EXPECT_TRUE(high.for_session);
  EXPECT_THAT(complaints, IsEmpty());
}

TEST_F(RoutingTableTest, TellsOfAConditionThatFails) {
  make(R"(<routes><filter source="*" command="Sound" if="_LPARAM1 lt 3"
          drop="true"/></routes>)");
  EXPECT_TRUE(table->route(event("Mic", "Sound", {Value(List{})})).for_session);
  EXPECT_EQ(table->counters().failed_conditions, 1u);
  EXPECT_THAT(complaints, ElementsAre(HasSubstr("Sound: ")));
  EXPECT_THAT(complaints, ElementsAre(HasSubstr("test.xml:")));
}

TEST_F(RoutingTableTest, EndsARing) {
  make(R"(<routes><relay source="Mic" command="Sound" to="Good"/></routes>)");
  auto far = event("Mic", "Sound");
  far.rounds = RoundLimit::honest_rounds + 1;
  for (std::uint32_t i = 0; i < RoundLimit::each_second; ++i)
    ASSERT_TRUE(table->route(far).for_session);
  for (int i = 0; i < 3; ++i) {
    const auto routed = table->route(far);
    EXPECT_FALSE(routed.for_session);
    EXPECT_THAT(routed.deliveries, IsEmpty());
  }
  EXPECT_EQ(table->counters().circled, 3u);
  EXPECT_THAT(complaints, ElementsAre(HasSubstr("goes in a ring")));
  EXPECT_TRUE(table->route(event("Mic", "Sound")).for_session); // from outside
}

TEST_F(RoutingTableTest, ACopyIsARoundFurther) {
  make(R"(<routes><relay source="Mic" command="Sound" to="Good"/></routes>)");
  const auto routed = table->route(event("Mic", "Sound"));
  EXPECT_EQ(routed.deliveries.at(0).message->rounds, 1u);
  EXPECT_EQ(routed.for_session->rounds, 0u);
}

TEST_F(RoutingTableTest, DropsAndTakesRoutesInFileOrder) {
  make(R"(<routes><relay source="*" command="Sound" to="Good"/>
          <filter source="*" command="Sound" drop="true"/>
          <relay source="*" command="Sound" to="Fast"/></routes>)");
  auto routed = table->route(event("Anyone", "Sound"));
  EXPECT_THAT(delivered(routed), ElementsAre(HasSubstr("Good: ")));
  EXPECT_FALSE(routed.for_session);
  EXPECT_EQ(table->counters().dropped, 1u);
  EXPECT_EQ(table->counters().relayed, 1u);
}

TEST_F(RoutingTableTest, KnowsRolesNamesAndAliases) {
  make("");
  EXPECT_TRUE(table->is_source("Record", "Mic"));
  EXPECT_TRUE(table->is_source("Microphone", "Mic"));
  EXPECT_TRUE(table->is_source("ASR", "Good"));
  EXPECT_TRUE(table->is_source("ASR", "ASR"));
  EXPECT_TRUE(table->is_source("*", "anyone"));
  EXPECT_FALSE(table->is_source("ASR", "Mic"));
  EXPECT_FALSE(table->is_source("Good", "Fast"));
  EXPECT_EQ(table->find("Record", "")->name, "Mic");
  EXPECT_EQ(table->find("Nobody", ""), nullptr);
}

TEST_F(RoutingTableTest, KnowsWhoListens) {
  make("");
  EXPECT_TRUE(table->is_listened_to(event("Fast", "RecognitionResult")));
  EXPECT_FALSE(table->is_listened_to(event("Fast", "Partial")));
}

// Of two of a role, each session has the first where it has one that is up.
TEST_F(RoutingTableTest, AComponentMayHaveABranchForEachSession) {
  make("");
  EXPECT_FALSE(table->has_instances_by_session());
  auto by_session = std::make_shared<InstanceList>();
  const auto mailbox = std::make_shared<ComponentMailbox>();
  const auto is_up = std::make_shared<std::atomic<bool>>(true);
  by_session->put("s1", {mailbox, is_up});
  RoutingTable::Parts parts;
  parts.program = compile(echo);
  Target own;
  own.name = "Own";
  own.roles = {"ASR"};
  own.by_session = by_session;
  parts.targets = {own, {"All", {"ASR"}, {}, nullptr, up.front()}};
  const RoutingTable with(std::move(parts));
  EXPECT_TRUE(with.has_instances_by_session());
  EXPECT_EQ(with.find("ASR", "s1")->name, "Own");
  EXPECT_EQ(with.find("ASR", "s1")->mailbox_of("s1"), mailbox);
  EXPECT_EQ(with.find("ASR", "s2")->name, "All");
  EXPECT_EQ(with.find("Own", "s2"), nullptr);
  *is_up = false;
  EXPECT_EQ(with.find("ASR", "s1")->name, "All");
}

// Engine rule 1.3: the role says it, else the component of its own events.
TEST_F(RoutingTableTest, KnowsWhatEndsARequest) {
  make("");
  EXPECT_EQ(table->reply_to_request(event("Mic", "Started")), Reply::answer);
  EXPECT_EQ(table->reply_to_request(event("Fast", "Partial")), Reply::none);
  EXPECT_EQ(table->reply_to_request(event("ASR", "Partial")), Reply::none);
  EXPECT_EQ(table->reply_to_request(event("Record", "Failed")), Reply::refusal);
  EXPECT_EQ(table->reply_to_request(event("Fast", "Noise")), Reply::none);
  EXPECT_EQ(table->reply_to_request(event("Fast", "Other")), Reply::answer);
  EXPECT_EQ(table->reply_to_request(event("agent", "Noise")), Reply::answer);
}

// Engine rule 1.9.
TEST_F(RoutingTableTest, PassesOnNewValuesToAllWhoKnowThem) {
  make("");
  auto changed = event("Database", "ValuesChanged", {"db:a.b", List{"x"}});
  changed.session.clear();
  EXPECT_THAT(delivered(table->route(changed)),
              ElementsAre(HasSubstr("Fast: Database.SetValues(db:a.b, [x])"),
                          HasSubstr("Good: Database.SetValues(db:a.b, [x])")));
  EXPECT_THAT(taps,
              ElementsAre("SetValues relay -> Fast", "SetValues relay -> Good",
                          "ValuesChanged every session"));
  EXPECT_EQ(table->counters().messages(), 1u);
  *up[1] = false;
  EXPECT_EQ(table->route(changed).deliveries.size(), 1u);
  changed.source = "Mic";
  EXPECT_TRUE(table->route(changed).deliveries.empty());
}

} // namespace
} // namespace parlour::actors
