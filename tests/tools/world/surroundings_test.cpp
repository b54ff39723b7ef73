#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "script/compiler/compiler.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/world/surroundings.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;
using dialogue::Conversation;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

std::shared_ptr<const script::Program> compile(const std::string& script) {
  const test::TemporaryFolder folder;
  folder.write("x.xml", "<dialogue>" + script + "</dialogue>");
  auto compiled = script::compile_file(folder.path() / "x.xml", {});
  for (const auto& finding : compiled.findings.all())
    ADD_FAILURE() << script::to_string(finding);
  return compiled.program;
}

class SurroundingsTest : public testing::Test {
protected:
  // `body` is what the script does when the bell rings.
  void open(const std::string& body) {
    world = std::make_unique<Surroundings>(
        compile("<handler name=\"Ring\"><messages><component><Bell><Rings>" +
                body + "</Rings></Bell></component></messages></handler>"));
    world->hears = [this](const dialogue::Output& output) {
      heard.push_back(output.text);
    };
    world->components = {{"Bell", {}}, {"SQLite", {"Database"}}};
    world->conversation = std::make_unique<Conversation>(
        world->program, Conversation::Options(), *world);
    world->conversation->open(world->now);
    EXPECT_TRUE(world->run());
  }
  void receive() {
    Message message;
    message.source = "Bell";
    message.command = "Rings";
    world->conversation->receive(std::move(message));
  }
  void ring() {
    receive();
    EXPECT_TRUE(world->run());
  }

  std::unique_ptr<Surroundings> world;
  std::vector<std::string> heard;
};

TEST_F(SurroundingsTest, HearsWhatIsSaidAndEndsIt) {
  open("<speak param='One.'/><speak param='Two.'/>");
  ring();
  EXPECT_THAT(heard, ElementsAre("One.", "Two."));
  EXPECT_THAT(world->playing, IsEmpty());
}

TEST_F(SurroundingsTest, HoldsOutputsIfItIsTold) {
  open("<speak param='One.'/><speak param='Two.'/>");
  world->hold_outputs = true;
  ring();
  EXPECT_THAT(world->playing, SizeIs(2));
  world->hold_outputs = false;
  EXPECT_TRUE(world->run());
  EXPECT_THAT(heard, ElementsAre("One.", "Two."));
}

TEST_F(SurroundingsTest, TimePassesOnlyWhenItIsTold) {
  open("<wait for='2s'/><speak param='Two.'/>");
  const auto start = world->now;
  ring();
  EXPECT_EQ(world->timers(), 1u);
  EXPECT_TRUE(world->advance(1s));
  EXPECT_THAT(heard, IsEmpty());
  EXPECT_TRUE(world->advance(5s));
  EXPECT_THAT(heard, ElementsAre("Two."));
  EXPECT_EQ(world->now, start + 6'000);
}

TEST_F(SurroundingsTest, FindsNothingUnlessADatabaseIsGiven) {
  open("<querydb param='select name from staff' return='r'/>"
       "<speak param='{length(r)}'/>");
  ring();
  world->database = [](const auto&) {
    return ResultSet{{"name"}, {"Ong", "Tay"}};
  };
  ring();
  EXPECT_THAT(heard, ElementsAre("0", "2"));
}

TEST_F(SurroundingsTest, HoldsQueriesIfItIsTold) {
  open("<querydb param='select 1' return='r'/><speak param='Asked.'/>");
  world->hold_queries = true;
  ring();
  EXPECT_THAT(world->queries, SizeIs(1));
  EXPECT_THAT(heard, IsEmpty());
  world->hold_queries = false;
  EXPECT_TRUE(world->run());
  EXPECT_THAT(heard, ElementsAre("Asked."));
}

// Without a network a request waits for whoever runs the world.
TEST_F(SurroundingsTest, OpensSocketsAsTheNetworkSays) {
  open("<try><socket name='feed' connect='there:1'/><speak param='open'/>"
       "<catch name='e'><speak param='{e.message}'/></catch></try>");
  ring();
  EXPECT_THAT(world->opening, SizeIs(1));
  world->network = [](const auto&) {
    return fail(ErrorKind::network, "no network");
  };
  EXPECT_TRUE(world->run());
  EXPECT_THAT(world->opening, IsEmpty());
  EXPECT_THAT(heard, ElementsAre("no network"));
}

TEST_F(SurroundingsTest, KnowsWhoIsThereAndWhatTheyFill) {
  open("<speak param='x'/>");
  EXPECT_TRUE(world->reachable("Bell"));
  EXPECT_TRUE(world->reachable("Database"));
  EXPECT_FALSE(world->reachable("TTS"));
  EXPECT_TRUE(world->is_source("Database", "SQLite"));
  EXPECT_TRUE(world->is_source("Stranger", "Stranger"));
  EXPECT_FALSE(world->is_source("Database", "Bell"));
}

TEST_F(SurroundingsTest, ErrorsAreSeenInAnyCaseAllElseIfItIsTold) {
  std::vector<InspectionKind> kinds;
  open("<speak param='{1 / 0}'/>");
  world->sees = [&](const Inspection& one) { kinds.push_back(one.kind); };
  ring();
  EXPECT_THAT(kinds, Each(InspectionKind::error));
  EXPECT_FALSE(kinds.empty());
  world->inspects_all = true;
  ring();
  EXPECT_GT(kinds.size(), 2u);
}

// Each output rings the bell again.
TEST_F(SurroundingsTest, SaysWhenThereIsNoRest) {
  open("<speak param='Again.'/>");
  world->hears = [this](const dialogue::Output&) { receive(); };
  receive();
  EXPECT_FALSE(world->run());
  EXPECT_FALSE(world->advance(1s));
}

TEST_F(SurroundingsTest, TheConversationMayComputeItsFramesItself) {
  for (const bool actors : {true, false}) {
    world = std::make_unique<Surroundings>(
        compile("<topic name='Taxi'><slot name='To' type='Functional' "
                "question='Where?'/></topic>"));
    world->has_frame_actors = actors;
    world->conversation = std::make_unique<Conversation>(
        world->program, Conversation::Options(), *world);
    world->conversation->open(world->now);
    dialogue::Act act;
    act.topic = "Taxi";
    act.slots.push_back({"To", "airport", 0.95, {}, {}, false});
    const auto shared = std::make_shared<const dialogue::Act>(act);
    world->conversation->take_acts({&shared, 1}, world->now);
    EXPECT_TRUE(world->run());
    EXPECT_EQ(world->conversation->slot_value("Taxi", "To"), Value("airport"));
  }
}

} // namespace
} // namespace parlour::tools
