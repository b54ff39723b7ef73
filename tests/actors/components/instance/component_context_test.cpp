#include <optional>
#include <thread>

#include "actors/components/instance/component_context.hpp"
#include "tests/actors/bench.hpp"

namespace parlour::actors {
namespace {

class PluginDoorTest : public testing::Test {
protected:
  PluginDoorTest() {
    bench.bus.connect(bench.centre_probe());
  }

  supervisor_actor supervisor_probe() {
    auto done = [](const auto&) { return component_done{}; };
    return bench.spawn(
        [=, this](supervisor_actor::pointer,
                  Bench*) -> supervisor_actor::behavior_type {
          return {
              [=](const load_component& what) { return done(what); },
              [=](const load_plugin& what) { return done(what); },
              [=](const unload_component& what) { return done(what); },
              [](const stop_components&) {},
              [](const instance_started&) {},
              [](const instance_stopped&) {},
              [this](const component_failed& what) {
                bench.seen.push_back(what.name + " " +
                                     std::to_string(what.instance) +
                                     " failed: " + what.reason);
              },
              [this](const component_available& what) {
                bench.seen.push_back(std::to_string(what.instance) +
                                     (what.is_available ? " is" : " is not") +
                                     " available");
              },
              [](const watch_instance&) {},
              [](const instance_idle&) {},
              [](const try_again&) {},
              [this](const ask_component& what) {
                bench.seen.push_back("is to ask for " + what.request.command);
                asked.push_back(what);
              },
              [](const drain_over&) {},
              [](const seat_opened&) {},
              [](const seat_closed&) {},
              [](const session_begins&) { return session_settled{}; },
              [](const session_ended&) {},
              [](const change_environment&) { return environment_changed(); },
              no_status,
          };
        },
        &bench);
  }

  Bench bench;
  std::vector<ask_component> asked;
  SharedEnvironment environment;
  ComponentContext context{{bench.time, bench.bus, bench.observer, environment},
                           "Ear",
                           {"Ear", {"ASR"}, "hears"}};
};

TEST_F(PluginDoorTest, LetsNobodySpeakUnderAReservedName) {
  struct {
    const char* claimed;
    const char* published;
  } const cases[] = {{"", "Ear"},        {"Robot7", "Robot7"},
                     {"System", "Ear"},  {"Script", "Ear"},
                     {"Session", "Ear"}, {"Dialogue", "Ear"},
                     {"Timer", "Ear"}};
  for (const auto& [claimed, published] : cases) {
    bench.seen.clear();
    context.fire_event(event(claimed, "Heard"));
    bench.run();
    EXPECT_THAT(bench.seen, ElementsAre(std::string(published) + ".Heard()"))
        << claimed;
  }
}

TEST_F(PluginDoorTest, AnEventGoesNowhereInParticularAMessageDoes) {
  bench.set_table({bench.target("Robot7", {})});
  auto message = event("", "Stop");
  message.sinks = {"Robot7"};
  context.fire_event(message);
  context.send_message(message);
  bench.run();
  EXPECT_THAT(bench.seen,
              ElementsAre("Ear.Stop()", "Robot7 gets Ear.Stop() -> Robot7"));
}

// Each piece is counted in one place by all threads: one is handed on.
TEST_F(PluginDoorTest, WhatItSaysTakesTheWorkOfWhatItIsDoneWith) {
  QuiescenceTracker count;
  const auto robot = bench.target("Robot7", {});
  const auto host = bench.component_probe("host", robot.mailbox);
  robot.mailbox->add_worker(host);
  bench.set_table({robot});
  auto recycled = count.begin();
  ASSERT_TRUE(context.gives(event("Script", "Go"), 0, recycled));
  EXPECT_FALSE(recycled);
  auto message = event("", "Stop");
  message.sinks = {"Robot7"};
  context.send_message(message);
  context.send_message(message);
  EXPECT_FALSE(count.none());
  EXPECT_TRUE(robot.mailbox->take(host)); // and its work is over
  EXPECT_TRUE(count.none());
  bench.run();
  EXPECT_TRUE(bench.time.work.none());
}

TEST_F(PluginDoorTest, KeepsNoWorkWhenItRestsOrIsClosed) {
  QuiescenceTracker count;
  auto recycled = count.begin();
  context.gives(event("Script", "Go"), 0, recycled);
  context.drop_recycled();
  EXPECT_TRUE(count.none());
  recycled = count.begin();
  context.gives(event("Script", "Go"), 0, recycled);
  context.close();
  EXPECT_TRUE(count.none());
}

TEST_F(PluginDoorTest, CallsBackThroughTheHost) {
  auto host = bench.component_probe("host");
  context.belongs_to(host);
  int calls = 0;
  context.after(Milliseconds(5), [&] { ++calls; });
  EXPECT_TRUE(bench.time.due_times.component_pending());
  bench.run();
  EXPECT_EQ(calls, 1);
  EXPECT_THAT(bench.seen, ElementsAre("host is to wait"));
}

TEST_F(PluginDoorTest, ForgetsDelaysOfAHostThatIsGone) {
  context.after(Milliseconds(5), [] { FAIL() << "called back"; });
  bench.run();
  EXPECT_FALSE(bench.time.due_times.component_pending());
}

// The host has gone, but somebody still holds it: nobody takes the message.
TEST_F(PluginDoorTest, ForgetsDelaysOfAHostThatHasQuit) {
  auto host = bench.component_probe("host");
  context.belongs_to(host);
  caf::anon_send_exit(host, caf::exit_reason::user_shutdown);
  bench.run();
  context.after(Milliseconds(5), [] { FAIL() << "called back"; });
  bench.run();
  EXPECT_FALSE(bench.time.due_times.component_pending());
}

TEST_F(PluginDoorTest, ForgetsWhatIsCancelled) {
  const auto delay = context.after(Milliseconds(5), [] {});
  context.cancel(delay);
  context.cancel(delay);
  EXPECT_FALSE(bench.time.due_times.component_pending());
}

// From a thread of its own, the last before it is stopped: what it asked for
// waits until the actors have nothing to do, and it may be gone by then.
TEST_F(PluginDoorTest, TellsWhatAnInstanceSaidThatIsGone) {
  const ContextParts parts{bench.time, bench.bus, bench.observer, environment,
                           supervisor_probe()};
  std::optional<ComponentContext> gone;
  gone.emplace(parts, "Nose", PluginDescription{"Nose", {}, "smells"}, 1);
  const auto host = bench.component_probe("host");
  gone->belongs_to(host);
  std::thread([&] {
    gone->available(false);
    gone->failed("line cut");
    gone->after(Milliseconds(5), [] {});
    gone->ask(event("", "Help"), Milliseconds(5), [](const auto&) {});
  }).join();
  // Another stands in its place, so that nothing of it is left there.
  gone.emplace(ContextParts{bench.time, bench.bus, bench.observer, environment},
               "Eye", PluginDescription{"Eye", {}, "sees"}, 2);
  bench.run();
  EXPECT_THAT(bench.seen,
              ElementsAre("1 is not available", "Nose 1 failed: line cut",
                          "is to ask for Help", "host is to wait"));
}

// One too many is refused, and there is room again when one was answered.
TEST_F(PluginDoorTest, RefusesQuestionsBeyondABound) {
  const auto nose = std::make_shared<ComponentContext>(
      ContextParts{bench.time, bench.bus, bench.observer, environment,
                   supervisor_probe()},
      "Nose", PluginDescription{"Nose", {}, "smells"}, 1);
  nose->belongs_to(bench.component_probe("host"));
  std::vector<ErrorKind> kinds;
  const auto ask = [&] {
    nose->ask(event("", "Help"), Milliseconds(5), [&](const auto& outcome) {
      kinds.push_back(outcome.error().kind);
    });
    bench.run();
  };
  for (std::size_t i = 0; i < ComponentContext::max_questions; ++i)
    ask();
  EXPECT_EQ(asked.size(), ComponentContext::max_questions);
  EXPECT_THAT(kinds, testing::IsEmpty());
  ask();
  EXPECT_EQ(asked.size(), ComponentContext::max_questions);
  EXPECT_THAT(kinds, ElementsAre(ErrorKind::limit));
  asked.front().finished(fail(ErrorKind::timeout, "nobody answers"));
  bench.run();
  EXPECT_THAT(kinds, ElementsAre(ErrorKind::limit, ErrorKind::timeout));
  ask();
  EXPECT_EQ(asked.size(), ComponentContext::max_questions + 1);
}

TEST_F(PluginDoorTest, AnInstanceThatWantsTooManyDelaysIsBroken) {
  ComponentContext nose(
      {bench.time, bench.bus, bench.observer, environment, supervisor_probe()},
      "Nose", {"Nose", {}, "smells"}, 1);
  for (std::size_t i = 0; i < ComponentContext::max_delays; ++i)
    nose.after(Milliseconds(5), [] {});
  bench.run();
  EXPECT_THAT(bench.seen, testing::IsEmpty());
  nose.after(Milliseconds(5), [] {});
  nose.after(Milliseconds(5), [] {});
  bench.run();
  EXPECT_THAT(bench.seen, ElementsAre(testing::StartsWith("Nose 1 failed: ")));
}

TEST_F(PluginDoorTest, ShowsWhatThePlatformShares) {
  PluginEnvironment shared;
  shared.data_folder = "/data";
  shared.application_folder = "/app";
  environment.change(std::make_shared<const PluginEnvironment>(shared));
  EXPECT_EQ(context.data_folder(), "/data");
  EXPECT_EQ(context.application_folder(), "/app");
  EXPECT_EQ(context.clock().now(), nine_o_clock);
  EXPECT_EQ(context.column("db:t.c").error().kind, ErrorKind::database);
  shared.columns = [](const std::string& name) {
    return Expected<std::vector<std::string>>({name, "x"});
  };
  environment.change(std::make_shared<const PluginEnvironment>(shared));
  EXPECT_THAT(*context.column("db:t.c"), ElementsAre("db:t.c", "x"));
  context.log("is deaf");
  EXPECT_THAT(bench.logs, ElementsAre("Ear: is deaf"));
}

// Who has read what the scripts say of language has to be made anew when they
// change; whoever asks later is given what counts then.
TEST_F(PluginDoorTest, RemembersThatLanguageWasRead) {
  EXPECT_FALSE(context.has_read_language());
  context.data_folder();
  EXPECT_FALSE(context.has_read_language());
  PluginEnvironment changed;
  changed.understanding = std::make_shared<const UnderstandingModel>();
  environment.change(std::make_shared<const PluginEnvironment>(changed));
  EXPECT_EQ(context.understanding(), changed.understanding);
  EXPECT_TRUE(context.has_read_language());
}

} // namespace
} // namespace parlour::actors
