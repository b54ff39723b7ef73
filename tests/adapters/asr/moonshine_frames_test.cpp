#include <gmock/gmock.h>

#include "adapters/asr/moonshine_frames.hpp"

namespace parlour::adapters::moonshine {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(MoonshineFrames, AFrameIsALineAndItsPayload) {
  const std::vector<Sample> samples = {1, -1};
  EXPECT_EQ(audio_frame(7, samples),
            std::string("{\"type\":\"audio\",\"turn\":7,\"bytes\":4}\n") +
                std::string("\1\0\xff\xff", 4));
  EXPECT_EQ(finish_frame(7), "{\"type\":\"finish\",\"turn\":7}\n");
  EXPECT_EQ(cancel_frame(8), "{\"type\":\"cancel\",\"turn\":8}\n");
  EXPECT_EQ(words_frame({{"Ho", "food court"}, 1}),
            "{\"type\":\"words\",\"names\":1,\"bytes\":14}\nHo\nfood court\n");
  EXPECT_EQ(narrow_frame(7, {{"yes"}, 0}),
            "{\"type\":\"narrow\",\"turn\":7,\"names\":0,\"bytes\":4}\nyes\n");
  EXPECT_EQ(words_frame({}), "{\"type\":\"words\",\"names\":0}\n");
}

TEST(MoonshineFrames, WordsThatDoNotFitAreLeftOut) {
  const Words words{{50, std::string(50'000, 'x')}, 0};
  EXPECT_LT(words_frame(words).size(), (1 << 20) + 100);
  EXPECT_THAT(words_frame(words), HasSubstr("xxx\nxxx"));
}

TEST(MoonshineFrames, AModelComesInParts) {
  EXPECT_TRUE(language_frames("").empty());
  EXPECT_EQ(language_frames("bytes"),
            std::vector<std::string>{"{\"type\":\"language\",\"more\":false,"
                                     "\"rejects\":true,\"bytes\":5}\nbytes"});
  std::string model;
  while (model.size() < (2 << 20) + 5)
    model += "-1.5 one of many words\n";
  const auto frames = language_frames(model);
  EXPECT_EQ(frames.size(), 3u);
  std::string joined;
  for (const auto& frame : frames) {
    EXPECT_LT(frame.size(), (1 << 20) + 100);
    EXPECT_EQ(frame.find("\"more\":true") == std::string::npos,
              &frame == &frames.back());
    joined += frame.substr(frame.find('\n') + 1);
  }
  EXPECT_EQ(joined, model);
}

Answer answer(std::string_view line) {
  AnswerReader reader;
  reader.add(line);
  return reader.next().value().value();
}

TEST(MoonshineFrames, ReadsAResult) {
  const auto result =
      answer(R"({"type":"result","turn":3,"text":"Hello","confidence":0.5,)"
             R"("alternatives":[{"text":"Hallo","confidence":0.25,"more":1}],)"
             R"("words":[{"text":"Hello","confidence":2}, 7]})"
             "\n");
  EXPECT_EQ(result.kind, AnswerKind::result);
  EXPECT_EQ(result.turn, 3);
  EXPECT_EQ(result.text, "Hello");
  EXPECT_EQ(result.confidence, 0.5);
  EXPECT_EQ(result.alternatives,
            (List{Map{{"text", "Hallo"}, {"confidence", 0.25}}}));
  EXPECT_EQ(result.words, (List{Map{{"text", "Hello"}, {"confidence", 1.0}}}));
}

TEST(MoonshineFrames, ReadsReasons) {
  EXPECT_EQ(answer("{\"type\":\"failed\",\"reason\":\"no model\"}\n").text,
            "no model");
  EXPECT_EQ(
      answer("{\"type\":\"rejected\",\"turn\":1,\"reason\":\"noise\"}\n").kind,
      AnswerKind::rejected);
}

TEST(MoonshineFrames, AnswersComeInPieces) {
  AnswerReader reader;
  const std::string_view bytes = "{\"type\":\"ready\"}\n{\"type\":\"ready\"}\n";
  std::size_t answers = 0;
  for (const auto byte : bytes) {
    reader.add({&byte, 1});
    while (reader.next().value())
      ++answers;
  }
  EXPECT_EQ(answers, 2U);
}

TEST(MoonshineFrames, RefusesWhatIsNoAnswer) {
  for (const auto* const line :
       {"\n", "hello\n", "[]\n", "{}\n", "{\"type\":7}\n",
        "{\"type\":\"partially\"}\n", "{\"type\":\"result\"\n"}) {
    AnswerReader reader;
    reader.add(line);
    const auto read = reader.next();
    ASSERT_FALSE(read) << line;
    EXPECT_EQ(read.error().kind, ErrorKind::network);
    EXPECT_THAT(read.error().message, StartsWith("it says what cannot be"));
  }
}

TEST(MoonshineFrames, RefusesALineWithoutEnd) {
  AnswerReader reader;
  reader.add(std::string(AnswerReader::longest_line, 'x'));
  EXPECT_FALSE(reader.next().value());
  reader.add("x");
  EXPECT_FALSE(reader.next());
}

} // namespace
} // namespace parlour::adapters::moonshine
