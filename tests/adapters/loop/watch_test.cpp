#include <future>
#include <optional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include "adapters/loop/watch.hpp"
#include "tests/adapters/loop/pipe.hpp"
#include "tests/support/start_loop.hpp"

namespace parlour::adapters {
namespace {

using test::Pipe;
using testing::ElementsAre;
using testing::IsEmpty;

// Everything runs on the loop's thread; `done` ends the test.
class WatchTest : public testing::Test {
protected:
  ~WatchTest() override {
    loop->stop();
  }
  void on_loop(const Loop::Action& action) {
    std::promise<void> over;
    loop->post([&] {
      action();
      over.set_value();
    });
    over.get_future().wait();
  }
  void wait_until_done() {
    done.get_future().wait();
  }
  // After two rounds of the loop what is ready has been reported.
  void expect_silence() {
    on_loop([] {});
    on_loop([&] { EXPECT_THAT(seen, IsEmpty()); });
  }

  std::unique_ptr<Loop> loop = test::start_loop();
  Pipe pipe;
  std::optional<Watch> watch;
  std::vector<short> seen;
  std::promise<void> done;
};

TEST_F(WatchTest, ReportsOnceWhatIsReady) {
  watch.emplace(*loop, [&](short ready) {
    seen.push_back(ready);
    done.set_value();
  });
  on_loop([&] { watch->await(pipe.read_end(), POLLIN); });
  expect_silence();
  pipe.say();
  wait_until_done();
  on_loop([] {});
  on_loop([&] { EXPECT_THAT(seen, ElementsAre(POLLIN)); });
}

TEST_F(WatchTest, WaitsAgainWhenItIsToldSo) {
  watch.emplace(*loop, [&](short ready) {
    seen.push_back(ready);
    if (seen.size() == 3)
      return done.set_value();
    // What was not read is ready once more: nothing depends on an edge.
    watch->await(pipe.read_end(), POLLIN);
  });
  pipe.say();
  on_loop([&] { watch->await(pipe.read_end(), POLLIN); });
  wait_until_done();
  EXPECT_THAT(seen, ElementsAre(POLLIN, POLLIN, POLLIN));
}

TEST_F(WatchTest, ReportsAHangUpWhatWasWaitedForAndNotWithout) {
  watch.emplace(*loop, [&](short ready) {
    seen.push_back(ready);
    done.set_value();
  });
  pipe.close_write();
  on_loop([&] { watch->await(pipe.read_end(), 0); });
  expect_silence();
  on_loop([&] { watch->await(pipe.read_end(), POLLIN); });
  wait_until_done();
  EXPECT_THAT(seen, ElementsAre(POLLIN));
}

TEST_F(WatchTest, WaitsForRoomToWrite) {
  watch.emplace(*loop, [&](short ready) {
    seen.push_back(ready);
    done.set_value();
  });
  pipe.fill();
  on_loop([&] { watch->await(pipe.write_end(), POLLOUT); });
  expect_silence();
  pipe.close_read();
  wait_until_done();
  EXPECT_THAT(seen, ElementsAre(POLLOUT));
}

TEST_F(WatchTest, IsSilentOnceItIsStoppedOrWaitsForAnother) {
  Pipe other;
  watch.emplace(*loop, [&](short ready) {
    seen.push_back(ready);
    done.set_value();
  });
  on_loop([&] {
    watch->await(pipe.read_end(), POLLIN);
    watch->stop();
    pipe.say();
  });
  expect_silence();
  on_loop([&] {
    watch->await(pipe.read_end(), POLLIN);
    watch->await(other.read_end(), POLLIN);
  });
  expect_silence();
  other.say();
  wait_until_done();
  EXPECT_THAT(seen, ElementsAre(POLLIN));
}

// A library may close its socket and open another one, which gets the same
// number.
TEST_F(WatchTest, TakesANewDescriptorWithTheSameNumber) {
  auto first = std::make_unique<Pipe>();
  const auto number = first->read_end();
  watch.emplace(*loop, [&](short ready) {
    seen.push_back(ready);
    done.set_value();
  });
  on_loop([&] {
    watch->await(number, POLLIN);
    watch->stop();
    first.reset();
    first = std::make_unique<Pipe>();
    watch->await(first->read_end(), POLLIN);
  });
  ASSERT_EQ(first->read_end(), number);
  first->say();
  wait_until_done();
  EXPECT_THAT(seen, ElementsAre(POLLIN));
}

TEST_F(WatchTest, ReportsADescriptorThatIsNone) {
  const auto number = pipe.read_end();
  pipe.close_read();
  watch.emplace(*loop, [&](short ready) {
    seen.push_back(ready);
    done.set_value();
  });
  on_loop([&] { watch->await(number, POLLIN); });
  wait_until_done();
  EXPECT_THAT(seen, ElementsAre(POLLIN));
}

TEST_F(WatchTest, MayBeDestroyedWhileItReports) {
  watch.emplace(*loop, [&](short) {
    watch.reset();
    done.set_value();
  });
  pipe.say();
  on_loop([&] { watch->await(pipe.read_end(), POLLIN); });
  wait_until_done();
  on_loop([] {});
  EXPECT_NE(pipe.read_end(), -1);
  EXPECT_NE(fcntl(pipe.read_end(), F_GETFD), -1) << "it is not its own";
}

} // namespace
} // namespace parlour::adapters
