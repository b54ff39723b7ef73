#include <gmock/gmock.h>

#include "adapters/agents/zeromq/packed_lines.hpp"

namespace parlour::adapters::agents {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

AgentMessage command(std::string what) {
  AgentMessage message;
  message.component = "Robot";
  message.command = std::move(what);
  return message;
}

// What a reader makes of a frame: commands, or kinds of errors.
class PackedLinesTest : public testing::Test {
protected:
  std::vector<std::string> read(std::string_view lines) {
    std::vector<std::string> all;
    reader.read(lines, [&](Read<AgentMessage>&& message) {
      all.push_back(message ? message->command
                            : std::string(name_of(message.error().kind)) +
                                  ": " + message.error().sentence);
    });
    return all;
  }
  // Sends them to another socket.
  std::string sent() {
    zmq::context_t context;
    zmq::socket_t left(context, zmq::socket_type::pair);
    zmq::socket_t right(context, zmq::socket_type::pair);
    left.bind("inproc://here");
    right.connect("inproc://here");
    packed.send(left);
    zmq::message_t frame;
    EXPECT_TRUE(right.recv(frame));
    EXPECT_FALSE(frame.more());
    return frame.to_string();
  }

  PackedLines packed;
  PackedReader reader;
};

TEST_F(PackedLinesTest, CarriesManyMessagesAsOne) {
  packed.add(command("Goto"));
  packed.add(command("Stop"));
  EXPECT_THAT(read(sent()), ElementsAre("Goto", "Stop"));
  EXPECT_TRUE(packed.empty());
}

TEST_F(PackedLinesTest, AFullOneFits) {
  auto message = command("Say");
  message.parameters = {std::string((64 << 10) - 20, '"')};
  ASSERT_TRUE(may_be_packed(message));
  while (!packed.is_full())
    packed.add(command("Goto"));
  packed.add(message);
  const auto lines = sent();
  EXPECT_LE(lines.size(), max_packed_bytes);
  const auto all = read(lines);
  EXPECT_EQ(all.front(), "Goto");
  EXPECT_EQ(all.back(), "Say");
}

TEST_F(PackedLinesTest, ALongMessageTravelsByItself) {
  auto message = command("Say");
  message.parameters = {std::string(64 << 10, 'x')};
  EXPECT_FALSE(may_be_packed(message));
}

TEST_F(PackedLinesTest, RefusesPartsAndTooMuch) {
  EXPECT_THAT(read("text,,Robot,Goto\ntext,,Rob"),
              ElementsAre("Goto", HasSubstr("malformed: the last")));
  EXPECT_THAT(read("binary,,Robot,Audio,pcm,10\n12345"),
              ElementsAre(HasSubstr("malformed: the last")));
  EXPECT_THAT(read(std::string(max_packed_bytes + 1, '\n')),
              ElementsAre(HasSubstr("oversized")));
  // Nothing is left of them.
  EXPECT_THAT(read("text,,Robot,Goto\n"), ElementsAre("Goto"));
}

// Its payload would be taken for lines.
TEST_F(PackedLinesTest, ReadsNothingBehindAClosingMistake) {
  EXPECT_THAT(read("binary,,Robot,Audio,pcm,many\ntext,,Robot,Goto\n"),
              ElementsAre(HasSubstr("malformed")));
  EXPECT_THAT(read("text,,Robot,Goto\n"), ElementsAre("Goto"));
}

TEST_F(PackedLinesTest, SaysWhatIsWrongWithALine) {
  EXPECT_THAT(read("shout,,Robot\ntext,,Robot,Goto\n"),
              ElementsAre(HasSubstr("unknown"), "Goto"));
}

} // namespace
} // namespace parlour::adapters::agents
