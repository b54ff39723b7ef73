#include <stdexcept>

#include <caf/send.hpp>

#include "actors/node/node_runtime.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

// Notes when it starts and stops.
class Noting : public IPlugin {
public:
  Noting(std::vector<std::string>& notes, std::string name)
      : notes_(notes), name_(std::move(name)) {}
  void stop() override {
    notes_.push_back(name_ + " stops");
    if (name_ == "Bad")
      throw std::runtime_error("stuck");
  }

protected:
  Expected<void> on_start(const Options&) override {
    notes_.push_back(name_ + " starts");
    return {};
  }
  void on_message(const Message&) override {}

private:
  std::vector<std::string>& notes_;
  std::string name_;
};

class NodeRuntimeTest : public testing::Test {
protected:
  NodeRuntimeTest() {
    options.virtual_start = nine_o_clock;
    options.program = compile(std::string(loses_its_session) + R"(
      <state name="Here"><Entrance><speak param="Hello."/></Entrance>
      <Exit><speak param="Bye."/></Exit></state>)",
                              "", "Here");
    options.phrases = std::make_shared<ThrowingPhrases>();
    options.log = [this](const std::string& line) { logs.push_back(line); };
  }

  ComponentOrder noting(const std::string& name) {
    auto order = component(name, name, {});
    order.factory.create = [this, name] {
      return std::make_unique<Noting>(notes, name);
    };
    return order;
  }

  SeatCalls calls() {
    return {[this](const auto& session, const dialogue::Output& output) {
              notes.push_back(session.substr(0, 0) + output.text);
            },
            [this](const auto&) { notes.push_back("over"); }};
  }

  NodeOptions options;
  std::vector<std::string> logs;
  std::vector<std::string> notes;
};

TEST_F(NodeRuntimeTest, StartsDatabasesBeforeWhatReadsFromThem) {
  auto database = noting("Shelf");
  database.factory.description.roles = {"Database"};
  options.components = {noting("Ear"), std::move(database), noting("Mouth")};
  NodeRuntime runtime(std::move(options));
  ASSERT_TRUE(runtime.start_components());
  EXPECT_EQ(notes, (std::vector<std::string>{"Shelf starts", "Ear starts",
                                             "Mouth starts"}));
}

TEST_F(NodeRuntimeTest, ComesUpAndGoesDownInOrder) {
  options.components = {noting("Ear"), noting("Mouth")};
  NodeRuntime runtime(std::move(options));
  ASSERT_TRUE(runtime.start_components());
  EXPECT_FALSE(
      runtime.open_session(runtime.open_seat("desk", calls())).empty());
  runtime.stop();
  runtime.stop();
  EXPECT_THAT(notes, ElementsAre("Ear starts", "Mouth starts", "Hello.", "Bye.",
                                 "over", "Ear stops", "Mouth stops"));
  EXPECT_THAT(logs, IsEmpty());
}

TEST_F(NodeRuntimeTest, GoesDownWithAComponentThatDoesNotStopWell) {
  options.components = {noting("Bad"), noting("Mouth")};
  NodeRuntime runtime(std::move(options));
  ASSERT_TRUE(runtime.start_components());
  runtime.stop();
  EXPECT_THAT(notes, testing::Contains("Mouth stops"));
  EXPECT_THAT(logs, ElementsAre("Bad did not stop well: stuck"));
}

TEST_F(NodeRuntimeTest, SaysWhichFactoryMadeNothing) {
  auto none = component("None", "ASR", {});
  none.factory.create = [] { return nullptr; };
  auto throwing = component("Throwing", "ASR", {});
  throwing.factory.create = []() -> std::unique_ptr<IPlugin> {
    throw std::runtime_error("no such library");
  };
  struct {
    ComponentOrder order;
    const char* message;
  } const cases[] = {
      {none, "None: was not made: its factory gave none"},
      {throwing, "Throwing: was not made: no such library"},
  };
  for (const auto& [order, message] : cases) {
    auto wanted = options;
    wanted.components = {noting("Ear"), order};
    NodeRuntime runtime(std::move(wanted));
    auto started = runtime.start_components();
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().message, message);
  }
  EXPECT_THAT(
      notes, ElementsAre("Ear starts", "Ear stops", "Ear starts", "Ear stops"));
}

TEST_F(NodeRuntimeTest, DoesNotFallWithWhoeverWatches) {
  options.on_inspection = [](const Inspection&) {
    throw std::runtime_error("out of paper");
  };
  NodeRuntime runtime(std::move(options));
  runtime.open_session(runtime.open_seat("desk", calls()));
  EXPECT_THAT(notes, ElementsAre("Hello."));
  EXPECT_THAT(logs,
              testing::Each(std::string("who watches failed: out of paper")));
  EXPECT_THAT(logs, testing::Not(IsEmpty()));
}

// What a session's own handlers throw ends that session alone.
TEST_F(NodeRuntimeTest, LosesOneSessionAndGoesOn) {
  for (const bool virtual_time : {true, false}) {
    notes.clear();
    logs.clear();
    auto wanted = options;
    if (!virtual_time)
      wanted.virtual_start.reset();
    NodeRuntime runtime(std::move(wanted));
    auto seat = runtime.open_seat("desk", calls());
    auto lost = runtime.open_session(seat);
    runtime.scheduler().run_until_quiet(); // `notes` is one thread's at a time
    auto other = runtime.open_session(runtime.open_seat("desk", calls()));
    runtime.scheduler().run_until_quiet();
    const auto& sessions = runtime.sessions();
    Message breaks;
    breaks.source = "Bell";
    breaks.command = "Breaks";
    breaks.session = lost;
    caf::anon_send(sessions.find(lost),
                   deliver{{breaks}, runtime.time().work.begin()});
    // An actor's death is told by CAF, which counts as nobody's work.
    do
      runtime.scheduler().run_until_quiet();
    while (sessions.find(lost));
    runtime.scheduler().run_until_quiet();
    EXPECT_THAT(logs, ElementsAre(testing::AllOf(HasSubstr(lost),
                                                 HasSubstr("broken"))));
    EXPECT_FALSE(sessions.find(lost));
    EXPECT_TRUE(sessions.find(other));
    EXPECT_TRUE(sessions.find(runtime.open_session(seat)));
    runtime.scheduler().run_until_quiet();
    EXPECT_THAT(notes, ElementsAre("Hello.", "Hello.", "over", "Hello."));
  }
}

} // namespace
} // namespace parlour::actors
