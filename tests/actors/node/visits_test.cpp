// Seats that come and go while a node runs.
#include <atomic>
#include <future>
#include <thread>

#include "actors/node/node.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

class VisitorTest : public NodeFixture {
protected:
  // It still tells `seen` when it ends.
  ~VisitorTest() override {
    node.reset();
  }
  SeatId come() {
    SeatCallbacks calls;
    calls.on_session_begin = [this](const auto&) { seen.push_back("begins"); };
    calls.on_output = [this](const auto&, const dialogue::Output& output) {
      seen.push_back(output.text);
    };
    calls.on_turns_done = [this](const auto&, std::uint64_t turn) {
      seen.push_back("done " + std::to_string(turn));
    };
    calls.on_session_end = [this](const auto&) { seen.push_back("ends"); };
    const auto opened = node->begin_visit(std::move(calls));
    node->run_until_quiet();
    return opened;
  }
  std::vector<std::string> take() {
    node->run_until_quiet();
    return std::exchange(seen, {});
  }

  static constexpr const char* desk = R"(
    <state name="Desk"><Entrance><speak param="Hello."/></Entrance>
      <Exit><speak param="Bye."/></Exit></state>
    <handler name="H"><messages><component><ASR><RecognitionResult>
      <speak param="You said: {_LPARAM1}"/>
      <if cond="_LPARAM1 == 'end'"><end/></if>
    </RecognitionResult></ASR></component></messages></handler>)";
  std::vector<std::string> seen;
};

TEST_F(VisitorTest, HearsWhichTurnsAreAnswered) {
  start(desk, "", "Desk");
  const auto visitor = come();
  EXPECT_THAT(take(), ElementsAre("begins", "Hello."));
  node->enter_turn(visitor, 1, {"one", "two"});
  EXPECT_THAT(take(), ElementsAre("You said: one", "You said: two", "done 1"));
  node->enter_turn(visitor, 2, {"end"});
  EXPECT_THAT(take(), ElementsAre("You said: end", "Bye.", "done 2", "ends"));
  EXPECT_EQ(node->session_at(visitor), "");
  node->enter_turn(visitor, 3, {"late"}); // nobody is there
  EXPECT_THAT(take(), IsEmpty());
}

// The words that the components find take time; the turn is not answered
// before.
TEST_F(VisitorTest, ATurnIsAnsweredWhenItsAnswerIsSaid) {
  options.components = {
      component("Slow", "Weather", [](FunctionPlugin& self, const Message& of) {
        self.host().after(Milliseconds(50),
                          [&self, of] { self.answer(of, "Report"); });
      })};
  start(R"(<handler name="H"><messages><component><ASR><RecognitionResult>
      <request module="Weather" command="Get"/><speak param="It is sunny."/>
    </RecognitionResult></ASR></component></messages></handler>)");
  const auto visitor = come();
  take();
  node->enter_turn(visitor, 1, {"weather?"});
  EXPECT_THAT(take(), IsEmpty());
  node->advance(Milliseconds(60));
  EXPECT_THAT(take(), ElementsAre("It is sunny.", "done 1"));
}

TEST_F(VisitorTest, AVisitThatEndsIsForgotten) {
  start(desk, "", "Desk");
  const auto before = node->status().size();
  for (int i = 0; i < 3; ++i) {
    const auto visitor = come();
    node->end_visit(visitor);
    node->end_visit(visitor); // nothing happens
    EXPECT_THAT(take(), ElementsAre("begins", "Hello.", "Bye.", "ends"));
    node->enter_turn(visitor, 1, {"hello?"});
    EXPECT_THAT(take(), IsEmpty());
    EXPECT_EQ(node->session_at(visitor), "");
  }
  EXPECT_EQ(node->status().size(), before);
  EXPECT_THAT(logs, IsEmpty());
}

// What the session did not come to begins another one, which ends as well.
TEST_F(VisitorTest, ClosingEndsWhateverIsThere) {
  start(desk, "", "Desk");
  const auto before = node->status().size();
  const auto visitor = come();
  take();
  node->enter_turn(visitor, 1, {"end", "and on"});
  node->end_visit(visitor);
  take();
  EXPECT_EQ(node->status().size(), before);
}

TEST_F(VisitorTest, InstancesOfASeatGoWithIt) {
  auto ear = component("Ear", "Microphone", [](auto&, const Message&) {});
  ear.policy.scope.kind = Scope::Kind::seat;
  options.components = {std::move(ear)};
  start(desk, "", "Desk");
  node->run_until_quiet(); // the fixture's seat has one
  const auto before = node->status().size();
  const auto visitor = come();
  EXPECT_GT(node->status().size(), before);
  node->end_visit(visitor);
  node->run_until_quiet();
  node->advance(Milliseconds(5'000));
  EXPECT_EQ(node->status().size(), before);
}

TEST_F(VisitorTest, ComeAndGoFromAnyThreadInRealTime) {
  options.virtual_start.reset();
  options.real_start = nine_o_clock;
  start(desk, "", "Desk");
  EXPECT_LT(node->now() - nine_o_clock, 60'000);
  std::vector<std::thread> threads;
  std::atomic<int> ended = 0;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int round = 0; round < 20; ++round) {
        std::promise<void> begun;
        std::promise<void> done;
        SeatCallbacks calls;
        calls.on_session_begin = [&](auto&) { begun.set_value(); };
        calls.on_turns_done = [&](auto&, auto) { done.set_value(); };
        calls.on_session_end = [&](auto&) { ++ended; };
        const auto visitor = node->begin_visit(std::move(calls));
        begun.get_future().wait();
        node->enter_turn(visitor, 1, {"hello"});
        done.get_future().wait();
        node->end_visit(visitor);
      }
    });
  for (auto& thread : threads)
    thread.join();
  node->run_until_quiet();
  EXPECT_EQ(ended, 80);
  EXPECT_THAT(logs, IsEmpty());
}

} // namespace
} // namespace parlour::actors
