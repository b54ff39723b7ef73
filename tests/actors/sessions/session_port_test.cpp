#include "actors/components/supervisor.hpp"
#include "actors/sessions/session.hpp"
#include "actors/sessions/session_port.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

using dialogue::TimerOwner;
using Self = session_actor::stateful_pointer<session_state>;

dialogue::QueryRequest question() {
  dialogue::QueryRequest request;
  request.id = 5;
  request.sql = "select 1";
  return request;
}

// A port whose session does what the test says, and notes what it hears.
class SessionPortTest : public testing::Test {
protected:
  explicit SessionPortTest(const std::string& elements = "") : bench(elements) {
    bench.bus.connect(bench.centre_probe());
    parts.supervisor = bench.spawn(
        supervisor, SupervisionParts{bench.time, bench.bus, bench.observer,
                                     bench.sessions, instances, environment});
  }

  void with_port(std::function<void(SessionPort&)> use) {
    auto seat = bench.seat_probe();
    user = bench.spawn(
        [=, this](Self self, int) -> session_actor::behavior_type {
          auto port = std::make_shared<SessionPort>(
              self, std::make_shared<const SessionParts>(parts), "s1", seat);
          return session_with(
              self, {[=] { use(*port); },
                     [=, this](const timer_due& what) {
                       port->timer_is_over(what.id);
                       heard.push_back("rings " + std::to_string(what.id));
                     },
                     [=] { port->wake(); },
                     [=, this](const query_outcome& what) {
                       port->query_is_over(what.id);
                       heard.push_back(what.outcome
                                           ? "rows"
                                           : what.outcome.error().message);
                     }});
        },
        0);
    bench.send(user, begin_session{bench.work()});
  }

  // Posts "Robot.Greet(…)" to NLG; what comes back at once.
  std::vector<std::string> post(std::vector<Value> params = {}) {
    std::vector<std::string> back;
    with_port([&](SessionPort& port) {
      auto message = event("Session", "Greet", params);
      message.sinks = {"NLG"};
      message.correlation = 4;
      for (const auto& one : port.post(message))
        back.push_back(one.session + " " + to_string(one) + " to " +
                       std::to_string(one.correlation));
    });
    return back;
  }

  void install(InlineFunctionPlugin::Function function) {
    auto words = bench.target("Words", {"NLG"});
    words.direct = std::make_shared<InlineFunctionPlugin>(std::move(function));
    bench.set_table({words});
  }

  Bench bench;
  InstanceDirectory instances;
  SharedEnvironment environment;
  SessionParts parts{bench.time, bench.bus, bench.observer, bench.program};
  session_actor user;
  std::vector<std::string> heard;
};

TEST_F(SessionPortTest, PostsToAMailbox) {
  bench.set_table({bench.target("Words", {"NLG"})});
  EXPECT_THAT(post(), IsEmpty());
  EXPECT_THAT(bench.seen, ElementsAre("Words gets Session.Greet() -> NLG"));
}

TEST_F(SessionPortTest, AsksAnInlineComponentAtOnce) {
  install([](const Message& message) -> std::vector<Answer> {
    return {{"Text", message.params}, {"Done", {}}};
  });
  EXPECT_THAT(post({"hi"}),
              ElementsAre("s1 Words.Text(hi) to 4", "s1 Words.Done() to 4"));
  EXPECT_THAT(bench.seen, IsEmpty());
}

// <post to-session>: what is answered is not for who posted.
TEST_F(SessionPortTest, PostsForAnotherSessionAsAnybodyElse) {
  install([](const Message&) -> std::vector<Answer> {
    ADD_FAILURE() << "asked on behalf of this session";
    return {};
  });
  with_port([](SessionPort& port) {
    auto message = event("Script", "Greet");
    message.sinks = {"NLG"};
    message.session = "s2";
    EXPECT_THAT(port.post(message), IsEmpty());
  });
  EXPECT_THAT(bench.seen, ElementsAre("Words gets Script.Greet() -> NLG"));
}

TEST_F(SessionPortTest, AnswersForAnInlineComponentThatThrows) {
  install([](const Message&) -> std::vector<Answer> { throw 1; });
  EXPECT_THAT(post(), ElementsAre(HasSubstr("s1 Words.Failed(")));
}

TEST_F(SessionPortTest, CountsAndLogsOnceWhatNobodyTakes) {
  EXPECT_THAT(post(),
              ElementsAre("s1 NLG.Failed(nobody is there for it) to 4"));
  with_port([](SessionPort& port) { port.unhandled(event("Bell", "Rings")); });
  EXPECT_EQ(bench.bus.counters().unhandled, 2u);
  EXPECT_THAT(bench.logs, ElementsAre(HasSubstr("nobody is there for NLG"),
                                      HasSubstr("Bell.Rings(): ")));
}

TEST_F(SessionPortTest, IsInspectedWhenSomebodyListens) {
  with_port([](SessionPort& port) { EXPECT_FALSE(port.inspected()); });
  int shown = 0;
  bench.watch([&](const auto&) { ++shown; });
  with_port([](SessionPort& port) {
    EXPECT_TRUE(port.inspected());
    port.inspect({});
  });
  EXPECT_EQ(shown, 1);
}

TEST_F(SessionPortTest, TellsOfTroubleWithoutBeingWatched) {
  with_port([](SessionPort& port) {
    port.inspect({InspectionKind::error, "", "Type", "a.xml:3: no"});
    port.inspect({InspectionKind::log, "", "info", "here"});
    port.inspect({InspectionKind::slot, "", "T.S", ""});
  });
  EXPECT_THAT(bench.logs, ElementsAre("Type: a.xml:3: no", "info: here"));
  int shown = 0;
  bench.watch([&](const auto&) { ++shown; }, false);
  with_port([](SessionPort& port) {
    EXPECT_FALSE(port.inspected()); // nobody makes what is not wanted
    port.inspect({InspectionKind::error, "", "", ""});
  });
  EXPECT_EQ(shown, 1);
}

TEST_F(SessionPortTest, ATimerRingsOnceAndIsReplacedAndCancelled) {
  with_port([](SessionPort& port) {
    port.start_timer(1, nine_o_clock + 5, TimerOwner::script);
    port.start_timer(2, nine_o_clock + 5, TimerOwner::script);
    port.start_timer(1, nine_o_clock + 20, TimerOwner::script);
    port.start_timer(3, nine_o_clock + 5, TimerOwner::script);
    port.cancel_timer(3);
    port.cancel_timer(99);
  });
  bench.scheduler->advance(10ms);
  EXPECT_THAT(heard, ElementsAre("rings 2"));
  bench.scheduler->advance(1h);
  EXPECT_THAT(heard, ElementsAre("rings 2", "rings 1"));
  EXPECT_FALSE(bench.time.due_times.next());
}

TEST_F(SessionPortTest, ATimerThatIsOverdueRingsAtOnce) {
  with_port([](SessionPort& port) {
    port.start_timer(1, nine_o_clock - 5, TimerOwner::script);
  });
  EXPECT_THAT(heard, ElementsAre("rings 1"));
  EXPECT_FALSE(bench.time.due_times.next());
}

TEST_F(SessionPortTest, WhatTheEngineWatchesHasNoActor) {
  std::size_t working = 0;
  with_port([&](SessionPort& port) {
    port.start_timer(1, nine_o_clock + 5, TimerOwner::engine);
    port.start_timer(2, nine_o_clock + 5, TimerOwner::script);
    port.start_timer(3, nine_o_clock + 5, TimerOwner::engine);
    port.cancel_timer(3);
    working = port.children().size();
  });
  EXPECT_EQ(working, 1U);
  bench.scheduler->advance(10ms);
  EXPECT_THAT(heard, testing::UnorderedElementsAre("rings 1", "rings 2"));
  EXPECT_FALSE(bench.time.due_times.next());
}

TEST_F(SessionPortTest, AQueryHasAnOutcome) {
  with_port([](SessionPort& port) { port.query(question()); });
  EXPECT_THAT(heard, ElementsAre("no database component is there"));
  EXPECT_FALSE(bench.time.due_times.next());
}

TEST_F(SessionPortTest, LeavesNothingBehind) {
  bench.set_table({bench.target("db", {"Database"})});
  with_port([](SessionPort& port) {
    port.start_timer(1, nine_o_clock + 3'600'000, TimerOwner::script);
    port.query(question());
  });
  EXPECT_TRUE(bench.time.due_times.next());
  bench.send(user, end_session{bench.work()});
  EXPECT_FALSE(bench.time.due_times.next());
  EXPECT_TRUE(bench.time.work.none());
}

class SessionPortRelayTest : public SessionPortTest {
protected:
  SessionPortRelayTest()
      : SessionPortTest(R"(<routes>
          <relay source="Words" command="Failed" to="Words"/></routes>)") {}
};

// However the routes lead from one that is down to the next.
TEST_F(SessionPortRelayTest, AnswersOnceForComponentsThatAreDown) {
  const auto words = bench.target("Words", {"NLG"});
  words.mailbox->close("is down");
  bench.set_table({words});
  EXPECT_THAT(post(), ElementsAre("s1 Words.Failed(Words is down) to 4"));
  EXPECT_EQ(bench.bus.counters().unhandled, 2u);
}

} // namespace
} // namespace parlour::actors
