#include <thread>

#include <gtest/gtest.h>

#include "tools/bench/support/desk.hpp"

namespace parlour::tools {
namespace {

Message numbered(Correlation number) {
  Message message;
  message.correlation = number;
  return message;
}

TEST(Desk, gathers_events_of_any_thread_in_order) {
  Desk desk("/folder");
  std::thread other([&] {
    for (Correlation i = 0; i < 100; ++i)
      desk.fire_event(numbered(i));
  });
  std::vector<Message> events;
  for (Correlation next = 0; next < 100;) {
    desk.take(events);
    ASSERT_FALSE(events.empty());
    for (const auto& event : events)
      EXPECT_EQ(event.correlation, next++);
  }
  other.join();
}

} // namespace
} // namespace parlour::tools
