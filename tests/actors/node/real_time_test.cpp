#include <future>
#include <thread>

#include "actors/node/scheduler.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {
namespace {

// Time passes here, but nothing waits for a certain time to have passed.
class RealDriveTest : public testing::Test {
protected:
  RealDriveTest() {
    scheduler->configure(config);
    system = std::make_unique<caf::actor_system>(config);
    scheduler->attach(*system, time);
  }

  std::unique_ptr<Scheduler> scheduler = make_real_time(1);
  caf::actor_system_config config;
  NodeTime time{scheduler->clock(), scheduler->queue_kind()};
  std::unique_ptr<caf::actor_system> system;
};

TEST_F(RealDriveTest, IsQuietWhenNothingIsUnderWay) {
  EXPECT_TRUE(scheduler->run_until_quiet());
  auto work = time.work.begin();
  std::thread ends([&] { work.reset(); });
  EXPECT_TRUE(scheduler->run_until_quiet());
  EXPECT_TRUE(time.work.none());
  ends.join();
}

TEST_F(RealDriveTest, WaitsForSessionsThatWait) {
  time.work.session_waits(true);
  std::thread ends([&] { time.work.session_waits(false); });
  EXPECT_TRUE(scheduler->run_until_quiet());
  EXPECT_FALSE(time.work.sessions_wait());
  ends.join();
}

TEST_F(RealDriveTest, DoesNotWaitForADelayedAnswer) {
  time.work.session_waits(true);
  time.due_times.add(scheduler->clock().now() + 3'600'000,
                     DueTimes::Of::component);
  EXPECT_TRUE(scheduler->run_until_quiet());
}

TEST_F(RealDriveTest, WaitsForTheNextDueTime) {
  EXPECT_FALSE(scheduler->step_to_next_due(1h)); // there is none
  const auto id = time.due_times.add(scheduler->clock().now() + 60'000,
                                     DueTimes::Of::session);
  EXPECT_FALSE(scheduler->step_to_next_due(1s)); // too far
  std::thread fires([&] { time.due_times.remove(id); });
  // Whichever comes first, the wait or the firing: it ends long before the
  // hour.
  static_cast<void>(scheduler->step_to_next_due(1h));
  fires.join();
  EXPECT_FALSE(time.due_times.has(id));
}

TEST_F(RealDriveTest, IsInterrupted) {
  auto work = time.work.begin();
  std::thread interrupts([&] { time.work.interrupt(); });
  EXPECT_FALSE(scheduler->run_until_quiet());
  EXPECT_FALSE(scheduler->run_until([] { return false; }, 1h));
  interrupts.join();
}

TEST_F(RealDriveTest, AdvancesAtLeastThatFar) {
  const auto before = std::chrono::steady_clock::now();
  scheduler->advance(3ms);
  EXPECT_GE(std::chrono::steady_clock::now() - before, 3ms);
}

class RealNodeTest : public NodeFixture {};

// A plug-in's own thread, such as a server's, may outlive the node: it has made
// nothing there that the node would wait for.
TEST_F(RealNodeTest, EndsBeforeAThreadThatHasAsked) {
  std::promise<void> stopped;
  std::future<bool> has_outlived;
  options.virtual_start.reset();
  options.components = {component(
      "Ear", "NLU", [&](FunctionPlugin& self, const Message& message) {
        if (message.command != "Listen")
          return;
        std::promise<void> has_asked;
        has_outlived = std::async(std::launch::async, [&] {
          Message request;
          request.command = "Help";
          request.sinks = {"Nobody"};
          self.host().ask(request, 1min, [](const auto&) {});
          has_asked.set_value();
          return stopped.get_future().wait_for(10s) ==
                 std::future_status::ready;
        });
        has_asked.get_future().wait();
      })};
  start(R"(<handler name="Pipeline"><messages><component>
             <ASR><RecognitionResult>
               <post module="NLU" command="Listen"/>
             </RecognitionResult></ASR>
           </component></messages></handler>)");
  say({"hello"});
  EXPECT_TRUE(node->stop());
  stopped.set_value();
  EXPECT_TRUE(has_outlived.get());
}

} // namespace
} // namespace parlour::actors
