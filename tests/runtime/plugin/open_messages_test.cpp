#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "runtime/plugin/open_messages.hpp"

namespace parlour {
namespace {

TEST(OpenMessages, AreBoundedWhereThatIsWanted) {
  OpenMessages messages;
  EXPECT_TRUE(messages.open(2));
  EXPECT_TRUE(messages.open(2));
  EXPECT_FALSE(messages.open(2));
  EXPECT_TRUE(messages.open());
  messages.close();
  messages.close();
  EXPECT_TRUE(messages.open(2));
}

TEST(OpenMessages, AreWaitedFor) {
  OpenMessages messages;
  messages.wait_for_all();
  messages.open();
  messages.open();
  std::atomic<int> answered = 0;
  std::jthread other([&] {
    for (int i = 0; i < 2; ++i) {
      ++answered;
      messages.close();
    }
  });
  messages.wait_for_all();
  EXPECT_EQ(answered, 2);
}

TEST(OpenMessages, KeepWhatTheAnswerNeeds) {
  Message message;
  message.source = "Script";
  message.command = "Ask";
  message.params = {"lobby"};
  message.sinks = {"Weather"};
  message.session = "K3f9";
  message.correlation = 7;
  const auto kept = without_its_way(message);
  EXPECT_EQ(kept.command, "Ask");
  EXPECT_EQ(kept.params, message.params);
  EXPECT_EQ(kept.session, "K3f9");
  EXPECT_EQ(kept.correlation, 7u);
  EXPECT_TRUE(kept.sinks.empty());
}

} // namespace
} // namespace parlour
