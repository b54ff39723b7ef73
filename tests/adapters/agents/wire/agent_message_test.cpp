#include <gmock/gmock.h>

#include "adapters/agents/wire/agent_message.hpp"
#include "tests/adapters/agents/vectors.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;

TEST(AgentMessage, LeavesOutEmptyFieldsAtItsEnd) {
  AgentMessage message;
  message.kind = MessageKind::beat;
  EXPECT_THAT(fields_of(message).value(), ElementsAre("beat"));
  message.component = "Robot";
  EXPECT_THAT(fields_of(message).value(), ElementsAre("beat", "", "Robot"));
}

TEST(AgentMessage, KeepsEmptyParameters) {
  AgentMessage message;
  message.parameters = {"", ""};
  EXPECT_EQ(fields_of(message)->size(), 6U);
}

TEST(AgentMessage, RefusesAttributesThatAreTooLong) {
  AgentMessage message;
  message.sinks.assign(100, "AVeryLongNameOfASink");
  ASSERT_FALSE(fields_of(message));
  EXPECT_EQ(fields_of(message).error().kind, WireErrorKind::oversized);
  const auto head = "text;s=" + std::string(max_attribute_bytes, 'a');
  EXPECT_EQ(message_of({head}).error().kind, WireErrorKind::oversized);
}

TEST(AgentMessage, ReadsItsOwnFields) {
  for (const auto& example : vectors()["messages"]) {
    auto message = message_in(example["message"]);
    const auto fields = fields_of(message).value();
    if (message.payload)
      message.payload->bytes.clear(); // not among the fields
    EXPECT_EQ(message_of({fields.begin(), fields.end()}).value(), message)
        << example["name"];
  }
}

// The numbers come later, and may be long.
TEST(AgentMessage, KeepsRoomForItsNumbers) {
  AgentMessage message;
  message.session = std::string(max_attribute_bytes - 52, 's');
  ASSERT_TRUE(check_numbered(message));
  message.number = message.acknowledged = std::uint64_t{INT64_MAX};
  EXPECT_TRUE(fields_of(message));
  message.number = message.acknowledged = std::nullopt;
  message.session += "ss";
  EXPECT_TRUE(fields_of(message));
  EXPECT_EQ(check_numbered(message).error().kind, WireErrorKind::oversized);
}

} // namespace
} // namespace parlour::adapters::agents
