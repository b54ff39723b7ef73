#include <gmock/gmock.h>

#include "adapters/agents/wire/multipart.hpp"
#include "tests/adapters/agents/vectors.hpp"

namespace parlour::adapters::agents {
namespace {

std::vector<std::string> frames_in(const nlohmann::json& example) {
  return example["frames"].get<std::vector<std::string>>();
}

Read<AgentMessage> read(const std::vector<std::string>& frames) {
  return read_frames({frames.begin(), frames.end()});
}

WireErrorKind mistake(const std::vector<std::string>& frames) {
  const auto message = read(frames);
  EXPECT_FALSE(message);
  return message ? WireErrorKind::refused : message.error().kind;
}

TEST(Multipart, WritesTheExamples) {
  for (const auto& example : vectors()["messages"])
    EXPECT_EQ(frames_of(message_in(example["message"])).value(),
              frames_in(example))
        << example["name"];
}

TEST(Multipart, ReadsTheExamples) {
  for (const auto& example : vectors()["messages"])
    EXPECT_EQ(read(frames_in(example)).value(), message_in(example["message"]))
        << example["name"];
}

TEST(Multipart, AnswersAnotherProtocol) {
  EXPECT_EQ(mistake({}), WireErrorKind::version);
  EXPECT_EQ(mistake({"parlour/2", "beat"}), WireErrorKind::version);
}

TEST(Multipart, AnswersTheMistakes) {
  for (const auto& example : vectors()["frame_errors"])
    EXPECT_EQ(name_of(mistake(frames_in(example))), example["error"])
        << example["name"];
}

// What may be written may be read: only what the page counts is counted.
TEST(Multipart, ReadsTheLongestMessages) {
  AgentMessage message;
  message.session = std::string(900, 's');
  message.time = 1;
  message.number = 1;
  message.parameters = {std::string(max_message_bytes, 'a')};
  EXPECT_EQ(read(frames_of(message).value()).value(), message);
  message.parameters.emplace_back("b");
  EXPECT_EQ(frames_of(message).error().kind, WireErrorKind::oversized);
}

TEST(Multipart, AnswersMistakes) {
  const std::string protocol(protocol_frame);
  EXPECT_EQ(mistake({protocol}), WireErrorKind::malformed);
  EXPECT_EQ(mistake({protocol, "shout"}), WireErrorKind::unknown);
  EXPECT_EQ(mistake({protocol, "binary"}), WireErrorKind::malformed);
  EXPECT_EQ(mistake({protocol, "text", "", "X", "\xff"}),
            WireErrorKind::malformed);
  EXPECT_EQ(mistake({protocol, "text", "", "X", "Y",
                     std::string(max_message_bytes, 'a')}),
            WireErrorKind::oversized);
}

} // namespace
} // namespace parlour::adapters::agents
