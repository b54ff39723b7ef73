// MessageTap and TapListener (adapters/agents/PROTOCOL.md 6).
#include <chrono>
#include <semaphore>
#include <thread>

#include <gmock/gmock.h>

#include "adapters/agents/wire/parameters.hpp"
#include "adapters/agents/zeromq/message_tap.hpp"
#include "adapters/agents/zeromq/tap_listener.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::HasSubstr;

Message event(const std::string& source, const std::string& command,
              List params = {}) {
  Message message;
  message.source = source;
  message.command = command;
  message.params = std::move(params);
  return message;
}

// Publishes a greeting again and again until the listener hears it: what is
// published before it has connected is lost. Each wait is twice as long as the
// one before, so that the greetings are few, however late this thread comes to
// hear one: a full queue would lose what the test publishes next.
void connect(MessageTap& tap, TapListener& listener, const Message& greeting) {
  std::binary_semaphore is_heard{0};
  std::jthread greets([&] {
    auto wait = std::chrono::milliseconds(1);
    do {
      tap.publish(greeting);
      wait *= 2;
    } while (!is_heard.try_acquire_for(wait));
  });
  listener.next();
  is_heard.release();
}

// The next message that is no greeting.
AgentMessage after_greetings(TapListener& listener, const Message& greeting) {
  auto next = listener.next();
  while ((*next)->command == greeting.command)
    next = listener.next();
  return **next;
}

TEST(MessageTap, GivesACopyOfEachMessage) {
  const auto tap = MessageTap::open("tcp://127.0.0.1:*").value();
  const auto listener = TapListener::connect(tap->address(), {}).value();
  const auto greeting = event("Test", "Hello");
  connect(*tap, *listener, greeting);
  auto message = event("Robot", "Arrived", {"lobby", List{1, "two"}});
  message.session = "K3f9";
  message.sinks = {"Map", "Log"};
  message.correlation = 7;
  tap->publish(message);
  tap->publish(event("Map", "Shown"));
  const auto heard = after_greetings(*listener, greeting);
  const auto copy = message_from_agent(heard, true).value();
  EXPECT_EQ(to_string(copy), to_string(message));
  EXPECT_EQ(copy.session, "K3f9");
  EXPECT_EQ(copy.sinks, message.sinks);
  EXPECT_EQ(copy.correlation, 7u);
  EXPECT_EQ((*listener->next())->number, *heard.number + 1);
}

TEST(MessageTap, GivesWhatWasSubscribedTo) {
  const auto tap = MessageTap::open("tcp://127.0.0.1:*").value();
  const auto listener =
      TapListener::connect(tap->address(), {"Robot.A", "Test."}).value();
  const auto greeting = event("Test", "Hello");
  connect(*tap, *listener, greeting);
  tap->publish(event("Robot", "Sensor"));
  tap->publish(event("Robots", "Arrived"));
  tap->publish(event("Robot", "Arrived"));
  EXPECT_EQ(after_greetings(*listener, greeting).component, "Robot");
}

TEST(MessageTap, LeavesAGapForWhatCannotBeCarried) {
  const auto tap = MessageTap::open("tcp://127.0.0.1:*").value();
  const auto listener = TapListener::connect(tap->address(), {}).value();
  const auto greeting = event("Test", "Hello");
  connect(*tap, *listener, greeting);
  tap->publish(event("Robot", "First"));
  tap->publish(event("Camera", "Two", {Binary{"jpeg", {}}, Binary{"png", {}}}));
  tap->publish(event("Camera", "Huge", {std::string(max_message_bytes, 'x')}));
  tap->publish(event("Robot", "Last"));
  const auto first = after_greetings(*listener, greeting);
  const auto last = listener->next();
  EXPECT_EQ((*last)->command, "Last");
  EXPECT_EQ((*last)->number, *first.number + 3);
}

TEST(MessageTap, IsOnLoopbackOnly) {
  const auto tap = MessageTap::open("tcp://0.0.0.0:*");
  ASSERT_FALSE(tap);
  EXPECT_EQ(tap.error().kind, ErrorKind::settings);
}

TEST(MessageTap, SaysThatItsAddressIsInUse) {
  const auto tap = MessageTap::open("tcp://127.0.0.1:*").value();
  const auto second = MessageTap::open(tap->address());
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().kind, ErrorKind::network);
  EXPECT_THAT(second.error().message, HasSubstr("in use"));
}

} // namespace
} // namespace parlour::adapters::agents
