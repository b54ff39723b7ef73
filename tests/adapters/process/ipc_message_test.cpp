#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/process/ipc_message.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

std::string bytes_of(const IpcMessage& message) {
  return ipc_bytes(message).value();
}

TEST(IpcMessages, KnowTheirNames) {
  EXPECT_EQ(name_of(IpcKind::hello), "hello");
  EXPECT_EQ(name_of(IpcKind::reply), "reply");
}

TEST(IpcMessages, HaveUnknownFieldsPastTheirEnd) {
  const IpcMessage message{IpcKind::log, {"text"}};
  EXPECT_EQ(message.at(0), Value("text"));
  EXPECT_TRUE(message.at(1).is_unknown());
}

TEST(IpcMessages, AreReadAsTheyWereWrittenByteByByte) {
  IpcReader reader;
  std::vector<IpcMessage> messages;
  for (const char byte :
       bytes_of({IpcKind::log, {"text", 7}}) + bytes_of({IpcKind::done, {}})) {
    reader.add({&byte, 1});
    if (auto message = reader.next().value())
      messages.push_back(*message);
  }
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(messages[0].kind, IpcKind::log);
  EXPECT_EQ(messages[0].at(1), Value(7));
  EXPECT_EQ(messages[1].kind, IpcKind::done);
}

TEST(IpcMessages, HaveALargestLength) {
  const auto bytes =
      ipc_bytes({IpcKind::log, {std::string(longest_ipc_message, 'x')}});
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().kind, ErrorKind::limit);
  EXPECT_TRUE(
      ipc_bytes({IpcKind::log, {std::string(longest_ipc_message - 16, 'x')}}));
}

std::string trouble(std::string bytes) {
  IpcReader reader;
  reader.add(bytes);
  const auto message = reader.next();
  return message ? "" : message.error().message;
}

TEST(IpcMessages, TrustNothing) {
  const auto good = bytes_of({IpcKind::log, {"text"}});
  EXPECT_EQ(trouble(good), "");
  EXPECT_THAT(trouble(std::string(16, '\xff')), HasSubstr("a message of 1844"));
  auto kind = good;
  kind[8] = 99;
  EXPECT_THAT(trouble(kind), HasSubstr("a kind of message"));
  auto fields = good;
  fields[9] = 77;
  EXPECT_THAT(trouble(fields), HasSubstr("no type of value"));
  std::string none = good.substr(0, 10);
  none[0] = 2;
  none[9] = 0;
  EXPECT_EQ(trouble(none), "a message without fields");
  auto more = good + "x";
  ++more[0];
  EXPECT_THAT(trouble(more), HasSubstr("more bytes follow"));
}

} // namespace
} // namespace parlour::adapters
