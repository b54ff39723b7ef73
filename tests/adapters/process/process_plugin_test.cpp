#include <stdexcept>
#include <thread>

#include <sys/wait.h>

#include "tests/adapters/process/process_fixture.hpp"

namespace parlour::adapters {
namespace {

using ProcessPluginTest = ProcessTest;

TEST_F(ProcessPluginTest, AnswersInTheSessionAndWithTheCorrelation) {
  start();
  send("Echo", {"text", 7, Map{{"a", List{1.5, Value()}}}});
  ASSERT_EQ(host.events.size(), 1u);
  EXPECT_EQ(host.events[0].session, "s1");
  EXPECT_EQ(host.events[0].correlation, 7u);
  EXPECT_THAT(host.take_events(), ElementsAre("Echoed(text, 7, {a: [1.5, "
                                              "unknown]})"));
}

TEST_F(ProcessPluginTest, HasDoneAllThatAMessageAsksForWhenItReturns) {
  start();
  send("Flood", {2000});
  EXPECT_EQ(host.events.size(), 2000u);
  EXPECT_EQ(host.events[1999].params.at(0), Value(1999));
}

TEST_F(ProcessPluginTest, HandsOnWhatThePluginIsToKnow) {
  UnderstandingModel model;
  model.topics = {
      {"Visit", false, {{"Visitor", "", {}, "", false, false}}, {}}};
  host.model = std::make_shared<const UnderstandingModel>(model);
  host.data = "/data";
  host.application = "/application";
  host.time.set(123);
  start();
  host.time.set(456);
  EXPECT_EQ(host.readings, 0);
  send("Tell");
  EXPECT_EQ(host.readings, 1);
  EXPECT_THAT(host.take_events(),
              ElementsAre("Told(/data, /application, 456, Visitor)"));
  EXPECT_THAT(host.logs, ElementsAre("told"));
  ASSERT_EQ(host.sent.size(), 1u);
  EXPECT_THAT(host.sent[0].sinks, ElementsAre("Telephone"));
}

TEST_F(ProcessPluginTest, AnswersItsQuestionsMeanwhile) {
  host.columns =
      [](const std::string& name) -> Expected<std::vector<std::string>> {
    if (name == "db:a.b")
      return std::vector<std::string>{"one", "two"};
    return fail(ErrorKind::database, "there is no " + name);
  };
  start();
  send("Column", {"db:a.b"});
  send("Column", {"db:c.d"});
  send("Words", {"hello"});
  EXPECT_THAT(
      host.take_events(),
      ElementsAre("Column(2)", "Column(there is no db:c.d)", "Words(nobody)"));
}

struct Parrot : PhraseEvaluator {
  Rendering render(const Value& say) const override {
    if (say.if_string())
      return {"say " + say.text()};
    return {{}, {{ErrorKind::type, "no text", {}}}};
  }
};

TEST_F(ProcessPluginTest, HasItsPhrasesRenderedHere) {
  host.evaluator = std::make_shared<Parrot>();
  start();
  send("Words", {"hello"});
  send("Words", {7});
  EXPECT_THAT(host.take_events(),
              ElementsAre("Words(say hello)", "Words(no text)"));
}

TEST_F(ProcessPluginTest, CallsBackByThePlatformsTime) {
  host.time.set(0);
  start();
  send("Later");
  EXPECT_EQ(host.pending(), 3u);
  host.advance(Milliseconds(2500));
  EXPECT_THAT(host.take_events(), ElementsAre("One(1000)"));
  EXPECT_EQ(host.pending(), 1u);
  EXPECT_THROW(host.advance(Milliseconds(1000)), std::runtime_error);
}

TEST_F(ProcessPluginTest, AsksOtherComponents) {
  start();
  send("Ask", {"select 1"});
  send("Ask", {"select 2"});
  ASSERT_EQ(host.asked.size(), 2u);
  const auto& [request, reaction] = host.asked[0];
  EXPECT_EQ(request.command, "Query");
  EXPECT_THAT(request.sinks, ElementsAre("Database"));
  EXPECT_EQ(request.session, "s1");
  host.asked[1].reaction(fail(ErrorKind::timeout, "too late"));
  reaction(test::message("Result", {1}));
  EXPECT_THAT(host.take_events(),
              ElementsAre("Answered(too late)", "Answered(1)"));
}

TEST_F(ProcessPluginTest, PassesOnWhatItsThreadsFire) {
  start();
  for (int i = 0; i < 20; ++i)
    send("Think");
  ASSERT_TRUE(host.wait_for(20));
  EXPECT_EQ(host.events[19].command, "Thought");
  EXPECT_EQ(host.events[19].correlation, 7u);
}

TEST_F(ProcessPluginTest, ThrowsWhatThePluginThrowsAndGoesOn) {
  start();
  EXPECT_EQ(thrown("Throw"), "engine trouble");
  EXPECT_THAT(thrown("Large"), HasSubstr("are too many to go from one"));
  send("Echo", {1});
  EXPECT_THAT(host.take_events(), ElementsAre("Echoed(1)"));
  EXPECT_THAT(host.failures, IsEmpty());
}

TEST_F(ProcessPluginTest, RefusesWhatIsTooLongAndGoesOn) {
  start();
  EXPECT_THROW(send("Echo", {std::string(longest_ipc_message, 'x')}),
               std::runtime_error);
  send("Echo", {1});
  EXPECT_THAT(host.take_events(), ElementsAre("Echoed(1)"));
}

// -- what goes wrong at the start ---------------------------------------------

TEST_F(ProcessPluginTest, SaysWhyItDoesNotStart) {
  EXPECT_EQ(trouble(trial(), {{"start", "throw"}}), "cannot be made");
  EXPECT_EQ(trouble(trial(), {{"start", "refuse"}}), "a.db:3: no such file");
  EXPECT_EQ(trouble(trial(), {{"start", "exit"}}),
            "its process ended with status 1");
  EXPECT_EQ(trouble(shell("exit 3")), "its process ended with status 3");
  EXPECT_EQ(trouble(shell("kill -KILL $$")),
            "its process was killed by signal 9 (Killed)");
  EXPECT_EQ(trouble(shell("exec 3>&-; kill -STOP $$")),
            "its process hung up and did not end");
  EXPECT_THAT(trouble(shell("echo 0123456789 >&3; cat <&3")),
              HasSubstr("says what cannot be read: a message of 3978"));
  auto order = trial();
  order.program = "/no/such/program";
  EXPECT_THAT(trouble(order), HasSubstr("does not start: No such file"));
  EXPECT_THAT(host.failures, IsEmpty());
}

TEST_F(ProcessPluginTest, EndsWhatHangsWhileItStarts) {
  auto order = trial();
  order.start_within = Milliseconds(300);
  EXPECT_EQ(trouble(order, {{"start", "hang"}}),
            "its process did not answer in time");
  auto silent = shell("kill -STOP $$");
  silent.start_within = Milliseconds(20);
  EXPECT_EQ(trouble(silent), "its process did not answer in time");
}

TEST_F(ProcessPluginTest, WantsItsOwnVersion) {
  // hello(99, x): 8 bytes of length, kind 0, a list of an integer and a text.
  EXPECT_THAT(
      trouble(shell(R"(printf '\013\0\0\0\0\0\0\0\0\006\002\003\306\001\005)"
                    R"(\003xyz' >&3; cat <&3)")),
      HasSubstr("speaks version 99"));
}

// The process is given up while the platform still looks its question up, on
// the process's thread: the answer has no receiver, and nobody minds. A very
// long version gives the question the time to come between the two.
TEST_F(ProcessPluginTest, MayBeGivenUpWhileItIsAnswered) {
  bool asked = false;
  host.columns = [&, starter = std::this_thread::get_id()](const auto&) {
    asked = std::this_thread::get_id() != starter;
    siginfo_t hung_up;
    if (asked)
      waitid(P_ALL, 0, &hung_up, WEXITED | WNOWAIT);
    return fail(ErrorKind::database, "there is none");
  };
  // hello(xxx…) of 12,000,008 bytes, and column(1, x).
  const auto order = shell(
      R"(printf '\010\033\267\0\0\0\0\0\0\006\001\005\200\266\334\005' >&3;)"
      R"(head -c 12000000 /dev/zero | tr '\0' x >&3;)"
      R"(for i in $(seq 300); do)"
      R"( printf '\010\0\0\0\0\0\0\0\020\006\002\003\002\005\001x' >&3; done;)"
      R"(cat <&3 >/dev/null)");
  for (int i = 0; i < 20 && !asked; ++i)
    EXPECT_THAT(trouble(order), HasSubstr("speaks version xxx"));
  EXPECT_TRUE(asked);
}

// -- what goes wrong later ----------------------------------------------------

TEST_F(ProcessPluginTest, SaysThatItsProcessIsOver) {
  const std::pair<const char*, const char*> ways[] = {
      {"Exit", "its process ended with status 1"},
      {"Abort", "its process was killed by signal 6 (Aborted)"},
      {"Close", "its process hung up and did not end"},
      {"Rubbish", "its process says what cannot be read: a message of "}};
  for (const auto& [command, reason] : ways) {
    host.failures.clear();
    host.take_events();
    start();
    send(command); // when it returns, all is told
    EXPECT_THAT(host.failures, ElementsAre(HasSubstr(reason)));
    EXPECT_THAT(host.take_events(),
                ElementsAre(HasSubstr(std::string("Failed(") + reason)));
    send("Echo", {1}); // answered at once, and told no second time
    EXPECT_EQ(host.events.size(), 1u);
    EXPECT_EQ(host.failures.size(), 1u);
  }
}

TEST_F(ProcessPluginTest, EndsWhatFloods) {
  start();
  send("Many");
  ASSERT_TRUE(host.wait_for(1));
  EXPECT_THAT(host.failures,
              ElementsAre("its process wants to be called back more than 10000 "
                          "times at once"));
}

TEST_F(ProcessPluginTest, EndsWhatHangs) {
  auto order = trial();
  order.answer_within = Milliseconds(100);
  start(order);
  send("Hang");
  EXPECT_THAT(host.failures, ElementsAre("its process did not answer in time"));
  EXPECT_EQ(host.events.at(0).command, "Failed");
}

TEST_F(ProcessPluginTest, SaysWhatThePluginSaysOfItself) {
  start();
  send("Broken");
  EXPECT_THAT(host.failures, ElementsAre("my device is gone"));
  send("Exit"); // the end of what has failed is no second failure
  EXPECT_THAT(host.failures, ElementsAre("my device is gone"));
}

TEST_F(ProcessPluginTest, StopsAndStartsAgain) {
  start();
  send("Later");
  plugin->stop();
  EXPECT_EQ(host.pending(), 0u);
  EXPECT_TRUE(plugin->start(host, {}));
  send("Echo", {1});
  EXPECT_THAT(host.take_events(), ElementsAre("Echoed(1)"));
  plugin->stop();
  plugin->stop();
  EXPECT_THAT(host.failures, IsEmpty());
  EXPECT_THAT(host.logs, IsEmpty());
}

TEST_F(ProcessPluginTest, LeavesNothingBehind) {
  const auto before = open_descriptors();
  for (int i = 0; i < 20; ++i) {
    start();
    if (i % 2 == 0)
      plugin->stop();
    plugin.reset();
    trouble(shell("exit 1"));
  }
  EXPECT_EQ(open_descriptors(), before);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1); // no child, dead or alive
}

} // namespace
} // namespace parlour::adapters
