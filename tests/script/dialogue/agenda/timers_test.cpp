#include <utility>

#include <gtest/gtest.h>

#include "script/dialogue/agenda/timers.hpp"

namespace parlour::dialogue {
namespace {

using namespace std::chrono_literals;

class Ports : public Port {
public:
  std::map<TimerId, Timestamp> running;

  void start_timer(TimerId id, Timestamp due, TimerOwner) override {
    running[id] = due;
  }
  void cancel_timer(TimerId id) override {
    running.erase(id);
  }
  std::vector<Message> post(Message) override {
    return {};
  }
  void subscribe(const std::vector<Subscription>&) override {}
  bool reachable(const std::string&) const override {
    return false;
  }
  bool is_source(const std::string&, const std::string&) const override {
    return false;
  }
  Reply reply_to_request(const Message&) const override {
    return Reply::answer;
  }
  void release(const Output&) override {}
  void query(QueryRequest) override {}
  void file(QueryId, FileRequest) override {}
  void component(ComponentRequest) override {}
  void open_socket(SocketRequest) override {}
  Expected<void> send_socket(SocketId, const std::string&) override {
    return {};
  }
  void socket_taken(SocketId) override {}
  void close_socket(SocketId) override {}
  void apply(TopicId, std::shared_ptr<const FrameRequest>) override {}
  void unhandled(const Message&) override {}
  bool inspected() const override {
    return false;
  }
  void inspect(Inspection) override {}
  void ended() override {}
};

Timer script_timer(std::string name, Milliseconds every = 0ms) {
  Timer timer;
  timer.name = std::move(name);
  timer.every = every;
  return timer;
}

TEST(Timers, FireOnce) {
  Ports port;
  Timers timers(port);
  auto id = timers.start(5, script_timer("egg"));
  EXPECT_EQ(port.running.at(id), 5);
  port.running.clear();
  EXPECT_EQ(timers.fired(id, 5)->name, "egg");
  EXPECT_FALSE(timers.fired(id, 5));
  EXPECT_TRUE(port.running.empty());
}

TEST(Timers, RepeatUntilCancelledByName) {
  Ports port;
  Timers timers(port);
  auto id = timers.start(5, script_timer("tick", 7ms));
  port.running.erase(id);
  EXPECT_TRUE(timers.fired(id, 5));
  ASSERT_EQ(port.running.size(), 1u);
  const auto [next, due] = *port.running.begin();
  EXPECT_EQ(due, 12);
  timers.cancel_named("tick");
  EXPECT_TRUE(port.running.empty());
  EXPECT_FALSE(timers.fired(next, 12));
}

TEST(Timers, NamesAreScriptsOnly) {
  Ports port;
  Timers timers(port);
  Timer wait;
  wait.purpose = Timer::Purpose::wait;
  wait.wait = 3;
  timers.start(5, wait);
  timers.cancel_named("");
  EXPECT_EQ(port.running.size(), 1u);
  timers.cancel_wait(4);
  EXPECT_TRUE(timers.any(Timer::Purpose::wait));
  timers.cancel_wait(3);
  EXPECT_FALSE(timers.any(Timer::Purpose::wait));
  EXPECT_TRUE(port.running.empty());
}

TEST(Timers, ASessionHasSoManyOfScripts) {
  Ports ports;
  Timers timers(ports);
  const auto timer = [](int number) {
    return Timer{.name = std::to_string(number), .bytes = 10};
  };
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(timers.refuse(timer(i), 10'000));
    timers.start(1'000, timer(i));
  }
  EXPECT_TRUE(timers.refuse(timer(1000), 1'000'000)); // too many
  EXPECT_FALSE(timers.refuse(timer(7), 10'000));      // takes the other's place
  for (int i = 1; i < 1000; ++i)
    timers.cancel_named(std::to_string(i));
  EXPECT_FALSE(timers.refuse(timer(1), 20));
  EXPECT_TRUE(timers.refuse(timer(1), 19)); // too much
}

TEST(Timers, ThoseOfAVisitEndWithIt) {
  Ports port;
  Timers timers(port);
  auto of_state = script_timer("a");
  of_state.visit = 3;
  timers.start(5, of_state);
  const auto other = timers.start(5, script_timer("b"));
  const auto ring = timers.ring(of_state);
  timers.end_with([](VisitId visit) { return visit == 4; });
  EXPECT_EQ(port.running.size(), 2u);
  EXPECT_FALSE(ring->stopped);
  timers.end_with([](VisitId visit) { return visit == 3; });
  ASSERT_EQ(port.running.size(), 1u);
  EXPECT_TRUE(port.running.contains(other));
  EXPECT_TRUE(ring->stopped);
}

TEST(Timers, OneThatRepeatsRingsAgainWhenItsStatementsAreDone) {
  Ports port;
  Timers timers(port);
  const auto tick = script_timer("tick", 7ms);
  auto ring = timers.ring(tick);
  ASSERT_TRUE(ring);
  EXPECT_FALSE(timers.ring(tick));
  EXPECT_TRUE(timers.ring(script_timer("tock", 7ms)));
  EXPECT_TRUE(timers.ring(script_timer("tick"))); // rings once
  ring.reset();
  EXPECT_TRUE(timers.ring(tick));
}

TEST(Timers, ARingIsStoppedWithItsTimer) {
  Ports port;
  Timers timers(port);
  const auto ring = timers.ring(script_timer("egg"));
  timers.cancel_named("tea");
  EXPECT_FALSE(ring->stopped);
  timers.cancel_named("egg");
  EXPECT_TRUE(ring->stopped);
}

TEST(Timers, KeepASessionOpen) {
  Ports port;
  Timers timers(port);
  timers.start(1'000, script_timer("may be lost"));
  timers.start(1'000, Timer::Purpose::silence);
  EXPECT_FALSE(timers.keep_open());
  EXPECT_EQ(timers.pending().size(), 1u);
  auto egg = script_timer("egg");
  egg.keeps_open = true;
  const auto id = timers.start(1'000, egg);
  EXPECT_TRUE(timers.keep_open());
  timers.cancel(id);
  EXPECT_FALSE(timers.keep_open());
  timers.start(1'000, Timer::Purpose::wait);
  EXPECT_TRUE(timers.keep_open());
}

// One that is overdue repeats from when it rings at last.
TEST(Timers, AreDueAtTheSameTimesWithAnotherPort) {
  Ports port;
  Timers timers(port);
  const auto egg = timers.start(5, script_timer("egg"));
  const auto tick = timers.start(7, script_timer("tick", 7ms));
  timers.start(9, Timer::Purpose::silence);
  const auto before = std::exchange(port.running, {});
  timers.resume();
  EXPECT_EQ(port.running, before);
  EXPECT_TRUE(timers.fired(egg, 100));
  EXPECT_TRUE(timers.fired(tick, 100));
  EXPECT_EQ(port.running.rbegin()->second, 107);
}

TEST(Timers, CancelAll) {
  Ports port;
  Timers timers(port);
  auto id = timers.start(5, script_timer("a"));
  timers.start(5, script_timer("b"));
  timers.cancel(id);
  EXPECT_EQ(port.running.size(), 1u);
  timers.cancel_all();
  EXPECT_TRUE(port.running.empty());
}

} // namespace
} // namespace parlour::dialogue
