#include <gmock/gmock.h>

#include "adapters/agents/wire/text_line.hpp"
#include "runtime/base/random.hpp"
#include "runtime/base/text/utf8.hpp"
#include "tests/adapters/agents/vectors.hpp"

namespace parlour::adapters::agents {
namespace {

std::size_t below(Random& random, std::size_t end) {
  return static_cast<std::size_t>(random.next() % end);
}

AgentMessage say(std::string text) {
  AgentMessage message;
  message.component = "Robot";
  message.command = "Say";
  message.parameters = {std::move(text)};
  return message;
}

std::string line(const AgentMessage& message) {
  return line_of(message).value();
}

// Everything that the reader makes of these bytes.
std::vector<Read<AgentMessage>> read_all(LineReader& reader,
                                         std::string_view bytes) {
  std::vector<Read<AgentMessage>> all;
  reader.add(bytes);
  while (auto read = reader.next()) {
    all.push_back(std::move(*read));
    if (!all.back() && closes_connection(all.back().error()))
      break;
  }
  return all;
}

TEST(TextLine, WritesTheExamples) {
  for (const auto& example : vectors()["messages"])
    EXPECT_EQ(line(message_in(example["message"])), line_in(example))
        << example["name"];
}

TEST(TextLine, ReadsTheExamples) {
  for (const auto* part : {"messages", "readable"})
    for (const auto& example : vectors()[part]) {
      LineReader reader;
      const auto read = read_all(reader, line_in(example));
      ASSERT_EQ(read.size(), 1U) << example["name"];
      ASSERT_TRUE(read[0]) << example["name"] << read[0].error().sentence;
      EXPECT_EQ(*read[0], message_in(example["message"])) << example["name"];
    }
}

TEST(TextLine, AnswersTheMistakes) {
  for (const auto& example : vectors()["errors"]) {
    LineReader reader;
    const auto read = read_all(reader, line_in(example));
    ASSERT_FALSE(read.empty()) << example["name"];
    ASSERT_FALSE(read[0]) << example["name"];
    const auto& error = read[0].error();
    EXPECT_EQ(name_of(error.kind), example["error"]) << example["name"];
    EXPECT_EQ(closes_connection(error), closes_connection({error.kind, ""}) ||
                                            example.value("closes", false))
        << example["name"];
    EXPECT_FALSE(read[0].error().sentence.empty());
  }
}

// Wherever the network cuts the bytes.
TEST(LineReader, ReadsTheSameByteByByte) {
  std::string bytes;
  for (const auto& example : vectors()["messages"])
    bytes += line_in(example);
  LineReader whole;
  const auto expected = read_all(whole, bytes);
  LineReader reader;
  std::vector<Read<AgentMessage>> read;
  for (const char byte : bytes)
    for (auto& one : read_all(reader, {&byte, 1}))
      read.push_back(std::move(one));
  EXPECT_EQ(read, expected);
  EXPECT_EQ(read.size(), vectors()["messages"].size());
}

TEST(LineReader, GoesOnBehindAMalformedLine) {
  LineReader reader;
  const auto read =
      read_all(reader, "text,now,X,Y\n\n\r\n" + line(say("hello")));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_FALSE(read[0]);
  EXPECT_EQ(read[1]->parameters[0], "hello");
}

// What follows a line that cannot be read is still its payload, and no line.
TEST(LineReader, SkipsTheFollowingPayloadOfAMalformedLine) {
  LineReader reader;
  const auto read = read_all(
      reader, "binary;n=x,,Mic,BufferFull,pcm,5\nbeat\n" + line(say("hello")));
  ASSERT_EQ(read.size(), 2U);
  EXPECT_FALSE(read[0]);
  EXPECT_EQ(read[1]->parameters[0], "hello");
}

TEST(LineReader, RefusesALineThatDoesNotEnd) {
  LineReader reader;
  const std::string piece(64 << 10, 'a');
  for (int i = 0; i < 32; ++i)
    EXPECT_TRUE(read_all(reader, piece).empty());
  const auto read = read_all(reader, piece);
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].error().kind, WireErrorKind::oversized);
}

TEST(LineReader, RefusesWhatIsNotUTF8) {
  LineReader reader;
  const auto read = read_all(reader, "text,,X,\xff\n");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].error().kind, WireErrorKind::malformed);
}

TEST(TextLine, RefusesToWriteWhatCouldNotBeRead) {
  EXPECT_FALSE(line_of(say(std::string(max_message_bytes, 'a'))));
  auto message = say("hello");
  message.session = "two words";
  EXPECT_FALSE(line_of(message));
  message = say("hello");
  message.parameters.resize(max_parameters + 1);
  EXPECT_FALSE(line_of(message));
}

// Texts of any characters, also those with a meaning in lines.
TEST(TextLine, AnyTextArrivesAsItWas) {
  Random random(7);
  const std::string_view alphabet = ",\"\\\n\r \tan;=\x01";
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (auto length = below(random, 12); length > 0; --length)
      text += alphabet[below(random, alphabet.size())];
    LineReader reader;
    const auto read = read_all(reader, line(say(text)));
    ASSERT_EQ(read.size(), 1U) << text;
    ASSERT_TRUE(read[0]) << text << read[0].error().sentence;
    EXPECT_EQ(read[0]->parameters[0], text);
  }
}

// Every character needs two bytes: the line is longer than its message may be.
TEST(TextLine, ReadsTheLongestMessages) {
  for (const char c : {'\\', '"', '\n', 'a'}) {
    auto message = say(std::string(max_message_bytes - 8, c));
    message.number = 1;
    LineReader reader;
    const auto read = read_all(reader, line(message));
    ASSERT_EQ(read.size(), 1U) << c;
    ASSERT_TRUE(read[0]) << c << read[0].error().sentence;
    EXPECT_TRUE(*read[0] == message) << c;
    message.command = "Says";
    EXPECT_EQ(line_of(message).error().kind, WireErrorKind::oversized);
  }
}

TEST(TextLine, CountsThePayload) {
  LineReader reader;
  const auto read = read_all(
      reader, "binary,,X,Y,f," + std::to_string(max_message_bytes) + "\n");
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].error().kind, WireErrorKind::oversized);
}

// Whoever chooses the bytes of a payload must not be able to say something in
// the agent's name.
TEST(LineReader, NeverReadsAPayloadAsLines) {
  for (const std::string wrong :
       {"binary,,X,Y,f,five", "binary,,X,Y,\"f,5", "binary,,X,\xff,f,5",
        "\"binary;n=1\",,X,Y\\t,f,5", "binary"}) {
    LineReader reader;
    const auto read = read_all(reader, wrong + "\nbeat\n");
    ASSERT_EQ(read.size(), 1U) << wrong;
    EXPECT_EQ(read[0].error().kind, WireErrorKind::malformed);
    EXPECT_TRUE(closes_connection(read[0].error())) << wrong;
  }
}

// Fields are looked at in blocks: wherever it stands, a character that needs
// quotation marks or an escape is found.
TEST(TextLine, FindsWhatMustBeQuotedAnywhere) {
  for (const char special : {',', '"', '\n', '\r', '\\', ' '})
    for (std::size_t size = 1; size < 40; ++size)
      for (std::size_t at = 0; at < size; ++at) {
        AgentMessage message;
        message.component = "Robot";
        message.command = "Say";
        message.parameters = {std::string(size, 'x')};
        message.parameters[0][at] = special;
        LineReader reader;
        const auto read = read_all(reader, line_of(message).value());
        ASSERT_EQ(read.size(), 1U);
        ASSERT_EQ(read[0], message) << size << ' ' << at << ' ' << special;
      }
}

// Bytes that are read to where they are kept, in pieces of any size, among them
// messages that are longer than usual.
TEST(LineReader, GivesRoomForWhatArrives) {
  std::string stream;
  std::vector<std::string> expected;
  for (int i = 0; i < 60; ++i) {
    AgentMessage message;
    message.command = std::to_string(i);
    message.parameters = {std::string(i % 20 == 7 ? 200'000 : 700, 'x')};
    stream += line_of(message).value();
    expected.push_back(message.command);
  }
  LineReader reader;
  std::vector<std::string> commands;
  std::size_t step = 1;
  for (std::string_view rest = stream; !rest.empty();) {
    step = step * 7 % 40'009;
    const auto room = reader.room(step);
    ASSERT_GE(room.size(), step);
    const auto size = std::min(step, rest.size());
    rest.copy(room.data(), size);
    rest.remove_prefix(size);
    reader.added(size);
    while (auto read = reader.next())
      commands.push_back(read->value().command);
    EXPECT_EQ(reader.has_part(),
              commands.size() < expected.size() &&
                  stream[stream.size() - rest.size() - 1] != '\n');
  }
  EXPECT_EQ(commands, expected);
}

TEST(TextLine, QuotesOnlyWholeCharacters) {
  LineReader reader;
  std::string name;
  for (int i = 0; i < 40; ++i)
    name += "a\u20ac";
  for (const auto& wrong : {name, "text," + name, "text;" + name}) {
    const auto read = read_all(reader, wrong + '\n');
    EXPECT_FALSE(find_invalid_utf8(read.at(0).error().sentence)) << wrong;
  }
}

} // namespace
} // namespace parlour::adapters::agents
