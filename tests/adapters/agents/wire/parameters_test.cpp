#include <gmock/gmock.h>

#include "adapters/agents/wire/parameters.hpp"

namespace parlour::adapters::agents {
namespace {

Value there_and_back(const Value& value) {
  return value_of(parameter_of(value, true), true).value();
}

TEST(Parameters, KeepTheirTypesForWhoReadsJson) {
  const std::vector<Value> values = {
      Value(),
      true,
      7,
      std::int64_t{1} << 62,
      -2.5,
      "text",
      "\x01J1",
      "",
      List{1, "two", List{}},
      Map{{"x", 1.5}, {"near", List{"lift", Value()}}},
  };
  for (const auto& value : values) {
    const auto back = there_and_back(value);
    EXPECT_EQ(back, value);
    EXPECT_EQ(back.type(), value.type()) << value.text();
  }
}

TEST(Parameters, AreTextsForOthers) {
  EXPECT_EQ(parameter_of(Value(), false), "");
  EXPECT_EQ(parameter_of(true, false), "true");
  EXPECT_EQ(parameter_of(3, false), "3");
  EXPECT_EQ(parameter_of("\x01J1", false), "\x01J1");
  EXPECT_EQ(parameter_of(List{1, "two"}, false), "[1,\"two\"]");
  EXPECT_EQ(value_of("\x01J1", false).value(), Value("\x01J1"));
}

TEST(Parameters, ATextIsAText) {
  EXPECT_EQ(parameter_of("3", true), "3");
  EXPECT_EQ(value_of("3", true)->type(), ValueType::string);
}

TEST(Parameters, RowsAreMaps) {
  const ResultSet rows{{"name", "room"}, {"Ann", 5, "Bo", Value()}};
  EXPECT_EQ(parameter_of(rows, false),
            R"([{"name":"Ann","room":5},{"name":"Bo","room":null}])");
}

TEST(Parameters, AnswerWhatIsNoJson) {
  EXPECT_FALSE(value_of("\x01J{", true));
  EXPECT_FALSE(value_of("\x01J", true));
  EXPECT_FALSE(value_of("\x01J" + std::string(100'000, '['), true));
  std::string deep;
  for (int i = 0; i < 100; ++i)
    deep.insert(0, "[").append("]");
  EXPECT_FALSE(value_of("\x01J" + deep, true));
}

TEST(MessageForAgent, GoesThereAndBack) {
  Message message;
  message.time = 5;
  message.source = "Mic";
  message.command = "BufferFull";
  message.session = "K3f9";
  message.correlation = 4;
  message.sinks = {"ASR"};
  message.params = {Binary{"pcm", {std::byte{1}, std::byte{0}}}, 320};
  const auto wired = message_for_agent(message, true);
  ASSERT_TRUE(wired);
  EXPECT_EQ(wired->kind, MessageKind::binary);
  EXPECT_EQ(wired->payload->position, 0U);
  auto back = message_from_agent(*wired, true);
  ASSERT_TRUE(back);
  back->time = message.time; // the platform stamps what arrives
  EXPECT_EQ(*back, message);
}

TEST(MessageForAgent, HasOnePayload) {
  Message message;
  message.params = {Binary{"a", {}}, Binary{"b", {}}};
  EXPECT_FALSE(message_for_agent(message, true));
}

TEST(MessageForAgent, SaysHowLongItsAuthorWaits) {
  EXPECT_EQ(message_for_agent({}, true)->deadline, std::nullopt);
  EXPECT_EQ(message_for_agent({}, true, Milliseconds(500))->deadline, 500U);
}

} // namespace
} // namespace parlour::adapters::agents
