#include <atomic>
#include <future>
#include <thread>

#include "actors/node/node.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using NodeTest = NodeFixture;

TEST_F(NodeTest, AnswersAUserTurn) {
  start(echo);
  EXPECT_THAT(say({"hello"}), ElementsAre("You said: hello"));
}

TEST_F(NodeTest, AnswersARowOfTurnsInOrder) {
  start(echo);
  EXPECT_THAT(say({"one", "two"}),
              ElementsAre("You said: one", "You said: two"));
}

TEST_F(NodeTest, ReleasesTheOpeningPromptBeforeTheFirstTurn) {
  start(R"(<state name="Welcome"><Entrance><speak param="Hello."/></Entrance>
           </state>)",
        "", "Welcome");
  auto session = node->open(seat);
  EXPECT_THAT(said(), ElementsAre("Hello."));
  EXPECT_EQ(node->state(session), "Welcome");
  EXPECT_EQ(node->session_at(seat), session);
}

TEST_F(NodeTest, EndsASessionAndOpensAnother) {
  start(echo);
  auto first = node->open(seat);
  node->end(first);
  node->run_until_quiet();
  EXPECT_EQ(over, 1);
  EXPECT_EQ(node->session_at(seat), "");
  EXPECT_EQ(node->state(first), "");
  EXPECT_THAT(say({"again"}), ElementsAre("You said: again"));
  EXPECT_NE(node->session_at(seat), first);
}

// What the ended session did not come to begins the next one; nothing is lost.
TEST_F(NodeTest, TakesFurtherTurnsOfARowToTheNextSession) {
  start(R"(<handler name="H"><messages><component>
      <ASR><RecognitionResult>
        <speak param="You said: {_LPARAM1}"/>
        <if cond="_LPARAM1 == 'bye'"><end/></if>
      </RecognitionResult></ASR>
    </component></messages></handler>)");
  const auto first = node->open(seat);
  EXPECT_THAT(say({"bye", "hello", "you"}),
              ElementsAre("You said: bye", "You said: hello", "You said: you"));
  EXPECT_EQ(over, 1);
  EXPECT_NE(node->session_at(seat), first);
  EXPECT_NE(node->session_at(seat), "");
  EXPECT_THAT(say({"again"}), testing::Contains("You said: again"));
}

// It ends while the visitor speaks: the turn finds its session still there, but
// nobody at home.
TEST_F(NodeTest, TakesATurnThatComesDuringTheEndToTheNextSession) {
  watch = [&](const Inspection& seen) {
    if (seen.message && seen.message->command == "Ended" && over == 0)
      node->enter(seat, {"late"});
  };
  start(R"(<handler name="H"><messages><component>
      <ASR><RecognitionResult>
        <speak param="You said: {_LPARAM1}"/>
        <if cond="_LPARAM1 == 'bye'"><end/></if>
      </RecognitionResult></ASR>
    </component></messages></handler>)");
  const auto first = node->open(seat);
  EXPECT_THAT(say({"bye"}), ElementsAre("You said: bye", "You said: late"));
  EXPECT_EQ(over, 1);
  EXPECT_NE(node->session_at(seat), first);
  EXPECT_NE(node->session_at(seat), "");
  EXPECT_THAT(logs, IsEmpty());
}

// What nobody waits for does not open a session in an empty room.
TEST_F(NodeTest, OpensNoSessionForWhatIsNoTurn) {
  watch = [&](const Inspection& seen) {
    if (seen.message && seen.message->command == "Ended")
      node->inject(seen.session, [] {
        Message event;
        event.source = "System";
        event.command = "ComponentFailed";
        return event;
      }());
  };
  start(R"(<handler name="H"><messages><component>
      <ASR><RecognitionResult><end/></RecognitionResult></ASR>
    </component></messages></handler>)");
  say({"bye"});
  EXPECT_EQ(node->session_at(seat), "");
  EXPECT_THAT(unhandled, ElementsAre(HasSubstr("its session is over")));
}

// A component that never returns does not keep the node from stopping.
TEST_F(NodeTest, LeavesBehindWhatDoesNotEnd) {
  std::promise<void> begun;
  std::promise<void> released;
  std::promise<void> gone;
  options.virtual_start.reset();
  options.drain_time = Milliseconds(10);
  std::shared_ptr<void> token(nullptr, [&](void*) { gone.set_value(); });
  options.components = {component(
      "Stuck", "Taxi",
      [&, token = std::move(token)](auto&, const Message&) {
        begun.set_value();
        released.get_future().wait();
      },
      true)};
  start(R"(<handler name="H"><messages><component>
      <ASR><RecognitionResult><post module="Taxi" command="Book"/>
      </RecognitionResult></ASR></component></messages></handler>)");
  node->enter(seat, {"go"});
  begun.get_future().wait();
  EXPECT_FALSE(node->stop());
  EXPECT_FALSE(node->stop());
  node = nullptr;
  EXPECT_THAT(logs,
              ElementsAre("Stuck is still at work; stopping all the same",
                          "Stuck does not come to an end and is left behind"));
  released.set_value();
  gone.get_future().wait(); // all of it ends after all
}

TEST_F(NodeTest, EndsItsSessionsWhenItStops) {
  start(R"(<state name="Welcome"><Exit><speak param="Bye."/></Exit></state>)",
        "", "Welcome");
  node->open(seat);
  node->stop();
  EXPECT_THAT(said(), ElementsAre("Bye."));
  EXPECT_EQ(over, 1);
}

TEST_F(NodeTest, StopsInTheMiddle) {
  start(echo);
  node->enter(seat, {"never answered"});
  node->interrupt();
  EXPECT_FALSE(node->run_until_quiet());
  node->stop();
  node->stop();
}

TEST_F(NodeTest, SaysWhichComponentDoesNotStart) {
  class Broken : public IPlugin {
    Expected<void> on_start(const Options&) override {
      return fail(ErrorKind::settings, "there is no such file");
    }
    void on_message(const Message&) override {}
  };
  std::vector<std::string> stopped;
  class Well : public IPlugin {
  public:
    explicit Well(std::vector<std::string>& stopped) : stopped_(stopped) {}
    void on_message(const Message&) override {}
    void stop() override {
      stopped_.push_back("Well");
    }

  private:
    std::vector<std::string>& stopped_;
  };
  auto well = component("Well", "ASR", {});
  well.factory.create = [&] { return std::make_unique<Well>(stopped); };
  auto broken = component("Broken", "NLU", {});
  broken.factory.create = [] { return std::make_unique<Broken>(); };
  options.components = {well, broken};
  options.program = compile(echo);
  auto started = Node::start(std::move(options));
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().message, "Broken: there is no such file");
  EXPECT_THAT(stopped, ElementsAre("Well"));
}

TEST_F(NodeTest, KnowsSlots) {
  start(R"(<topic name="Order"><slot name="Drink" expr="'tea'"/></topic>)", "",
        "Order");
  auto session = node->open(seat);
  EXPECT_EQ(node->slot_value(session, "Order", "Drink"), Value("tea"));
  EXPECT_TRUE(node->slot_value("nobody", "Order", "Drink").is_unknown());
}

TEST_F(NodeTest, TakesInjectedMessages) {
  start(R"(<handler name="H"><messages><component><VAD><SpeechStarted>
           <speak param="at {_LPARAM1}"/>
           </SpeechStarted></VAD></component></messages></handler>)");
  Message event;
  event.source = "VAD";
  event.command = "SpeechStarted";
  event.params = {7};
  node->inject(node->open(seat), event);
  node->run_until_quiet();
  EXPECT_THAT(said(), ElementsAre("at 7"));
}

// Says by itself that something moved, whoever told it to look.
ComponentOrder radar() {
  return component("Radar", "Robot", [](auto& self, const Message&) {
    Message event;
    event.command = "Sensor";
    self.host().fire_event(std::move(event));
  });
}

TEST_F(NodeTest, TakesWhatBelongsToNobodyToThoseWhoSubscribed) {
  options.components = {radar()};
  start(R"(<handler name="H"><messages><component>
      <ASR><RecognitionResult>
        <switch expr="_LPARAM1">
          <case value="hark"><subscribe source="Robot" command="Sensor"/></case>
          <case value="rest"><unsubscribe source="Robot"/></case>
          <default><post module="Radar" command="Sense" param=""/></default>
        </switch>
      </RecognitionResult></ASR>
      <Radar><Sensor><speak param="{_SESSION}"/></Sensor></Radar>
    </component></messages></handler>)");
  EXPECT_THAT(say({"look"}), IsEmpty());
  EXPECT_THAT(unhandled, ElementsAre(HasSubstr("no session has subscribed")));
  EXPECT_THAT(say({"hark", "look"}), ElementsAre(node->session_at(seat)));
  const auto first = node->session_at(seat);
  open_seat();
  EXPECT_THAT(say({"look"}), ElementsAre(first));
  EXPECT_THAT(say({"hark", "look"}),
              testing::UnorderedElementsAre(first, node->session_at(seat)));
  EXPECT_THAT(say({"rest", "look"}), ElementsAre(first));
  node->end(first);
  EXPECT_THAT(say({"look"}), IsEmpty());
  EXPECT_EQ(unhandled.size(), 2u);
}

TEST_F(NodeTest, WorksInRealTime) {
  options.virtual_start.reset();
  start(echo);
  EXPECT_THAT(say({"one", "two"}),
              ElementsAre("You said: one", "You said: two"));
}

TEST(Node, ManyLiveInOneProcess) {
  auto program = compile(echo);
  std::vector<std::thread> threads;
  std::atomic<int> answers = 0;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int j = 0; j < 10; ++j) {
        NodeOptions options;
        options.program = program;
        options.virtual_start = nine_o_clock;
        auto node = std::move(*Node::start(std::move(options)));
        SeatCallbacks calls;
        calls.on_output = [&](const auto&, const auto&) { ++answers; };
        node->enter(node->open_seat(std::move(calls)), {"hello"});
        node->run_until_quiet();
      }
    });
  for (auto& thread : threads)
    thread.join();
  EXPECT_EQ(answers, 40);
}

} // namespace
} // namespace parlour::actors
