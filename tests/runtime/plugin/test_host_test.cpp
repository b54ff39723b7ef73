#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/test_host.hpp"

namespace parlour {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;

Message named(const std::string& command) {
  Message message;
  message.command = command;
  return message;
}

TEST(TestHost, KeepsWhatCameOnce) {
  TestHost host;
  host.fire_event(named("Event"));
  host.send_message(named("Sent"));
  host.log("a line");
  host.failed("broken");
  EXPECT_THAT(host.take_events(), ElementsAre(named("Event")));
  EXPECT_THAT(host.take_events(), IsEmpty());
  EXPECT_THAT(host.take_sent(), ElementsAre(named("Sent")));
  EXPECT_THAT(host.take_logs(), ElementsAre("a line"));
  EXPECT_THAT(host.take_failures(), ElementsAre("broken"));
}

TEST(TestHost, RunsWhatFallsDueInOrder) {
  TestHost host;
  std::string order;
  host.after(2s, [&] { order += "b"; });
  host.after(1s, [&] {
    order += "a";
    host.after(1s, [&] { order += "c"; });
  });
  host.cancel(host.after(1s, [&] { order += "never"; }));
  host.advance(1999ms);
  EXPECT_EQ(order, "a");
  host.advance(1ms);
  EXPECT_EQ(order, "abc");
  EXPECT_EQ(host.clock().now(), 2000);
}

TEST(TestHost, AnswersQuestionsThatNobodyIsThere) {
  TestHost host;
  std::string error;
  auto request = named("Query");
  request.sinks = {"Database"};
  host.ask(request, 1s,
           [&](const auto& outcome) { error = outcome.error().message; });
  EXPECT_EQ(error, "");
  host.advance(0ms);
  EXPECT_EQ(error, "nobody fills the role or has the name 'Database'");
  EXPECT_EQ(host.take_asked().size(), 1u);
}

TEST(TestHost, WaitsForWhatIsDue) {
  TestHost host;
  host.after(1s, [&] { host.fire_event(named("Late")); });
  EXPECT_TRUE(host.wait([&] { return !host.take_events().empty(); }, 2s));
  EXPECT_EQ(host.clock().now(), 1000);
}

TEST(TestHost, WaitsForOtherThreads) {
  TestHost host;
  std::thread other([&] { host.fire_event(named("Event")); });
  EXPECT_TRUE(host.wait([&] { return !host.take_events().empty(); }, 60s));
  other.join();
}

TEST(TestHost, WaitsNoLongerThanItIsTold) {
  TestHost host;
  host.after(1s, [&] { host.fire_event(named("Late")); });
  EXPECT_FALSE(host.wait([] { return false; }, 1ms));
  EXPECT_THAT(host.take_events(), IsEmpty());
}

} // namespace
} // namespace parlour
