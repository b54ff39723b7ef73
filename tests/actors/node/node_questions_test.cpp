#include <future>

#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>
#include <caf/typed_response_promise.hpp>

#include "actors/node/node_questions.hpp"
#include "actors/node/node_runtime.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

using clerk_actor =
    caf::typed_actor<caf::replies_to<get_state>::with<state_told>>;
using Promise = caf::typed_response_promise<state_told>;

// Actors in virtual or in real time, without a node.
class Office {
public:
  explicit Office(std::unique_ptr<Scheduler> its_scheduler)
      : scheduler(std::move(its_scheduler)) {
    scheduler->configure(config_);
    system = std::make_unique<caf::actor_system>(config_);
    scheduler->attach(*system, time);
  }
  ~Office() {
    if (clerk_)
      caf::anon_send_exit(clerk_, caf::exit_reason::kill);
    clerk_ = nullptr;
    time.work.forget_interrupt();
    scheduler->run_until_quiet();
  }

  // Answers as `how` does with the promise of it.
  clerk_actor clerk(std::function<void(clerk_actor::pointer, Promise)> how) {
    clerk_ = system->spawn(
        [how = std::move(how)](clerk_actor::pointer self,
                               int) -> clerk_actor::behavior_type {
          return {[=](const get_state&) {
            auto promise = self->make_response_promise<state_told>();
            how(self, promise);
            return promise;
          }};
        },
        0);
    return clerk_;
  }
  Expected<state_told> ask(const clerk_actor& whom) {
    return NodeQuestions(*system, *scheduler, time)
        .ask<state_told>(whom, get_state{});
  }

  std::unique_ptr<Scheduler> scheduler;
  NodeTime time{scheduler->clock(), scheduler->queue_kind()};
  std::unique_ptr<caf::actor_system> system;

private:
  caf::actor_system_config config_;
  clerk_actor clerk_;
};

class NodeQuestionsTest : public testing::TestWithParam<bool> {
protected:
  static bool is_virtual() {
    return GetParam();
  }
  Office office{is_virtual() ? make_virtual_time(nine_o_clock)
                             : make_real_time(1)};
};
INSTANTIATE_TEST_SUITE_P(InBothTimes, NodeQuestionsTest,
                         testing::Values(true, false),
                         [](const auto& kind) -> std::string {
                           return kind.param ? "Virtual" : "Real";
                         });

// It does not matter who is at work meanwhile.
TEST_P(NodeQuestionsTest, AreAnswered) {
  const auto busy = office.time.work.begin();
  const auto clerk = office.clerk(
      [](auto, Promise promise) { promise.deliver(state_told{"Desk"}); });
  const auto told = office.ask(clerk);
  ASSERT_TRUE(told) << to_string(told.error());
  EXPECT_EQ(told->state, "Desk");
}

TEST_P(NodeQuestionsTest, FailWhereTheActorHasEnded) {
  const auto clerk =
      office.clerk([](clerk_actor::pointer self, Promise promise) {
        promise.deliver(state_told{"Desk"});
        self->quit();
      });
  EXPECT_TRUE(office.ask(clerk));
  EXPECT_EQ(office.ask(clerk).error(),
            fail(ErrorKind::cancelled, "the application stops").value());
}

TEST_P(NodeQuestionsTest, AreInterrupted) {
  std::promise<void> asked;
  Promise kept;
  const auto clerk = office.clerk([&](auto, Promise promise) {
    kept = promise;
    asked.set_value();
    if (is_virtual())
      office.time.work.interrupt();
  });
  const auto interrupts = std::async(std::launch::async, [&] {
    asked.get_future().wait();
    office.time.work.interrupt();
  });
  EXPECT_EQ(office.ask(clerk).error(),
            fail(ErrorKind::cancelled, "interrupted").value());
  kept = {};
}

TEST(NodeQuestions, SayThatNothingComes) {
  Office office(make_virtual_time(nine_o_clock));
  Promise kept;
  const auto clerk =
      office.clerk([&](auto, Promise promise) { kept = promise; });
  EXPECT_EQ(office.ask(clerk).error(),
            fail(ErrorKind::timeout, "there is no answer").value());
  kept = {};
}

// A node that is never quiet, as somebody at another seat keeps it busy.
TEST(NodeQuestions, DoNotWaitForOtherSessions) {
  NodeOptions options;
  options.program = compile(R"(
    <state name="Here"><Entrance><speak param="Hello."/></Entrance></state>)",
                            "", "Here");
  options.components = {component("City", "Taxi", {})};
  NodeRuntime runtime(std::move(options));
  auto busy = runtime.time().work.begin();
  ASSERT_TRUE(runtime.start_components());
  std::promise<void> greeted;
  const auto session = runtime.open_session(runtime.open_seat(
      "desk", {[&](const auto&, const auto&) { greeted.set_value(); }, {}}));
  EXPECT_EQ(runtime.state_of(session), "Here");
  EXPECT_TRUE(runtime.unload("City"));
  greeted.get_future().wait();
  busy.reset();
}

} // namespace
} // namespace parlour::actors
