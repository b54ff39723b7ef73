#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/process/frames.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

std::string bytes_of(const Frame& frame) {
  return frame_bytes(frame).value();
}

TEST(Frames, KnowTheirNames) {
  EXPECT_EQ(name_of(FrameKind::hello), "hello");
  EXPECT_EQ(name_of(FrameKind::reply), "reply");
}

TEST(Frames, HaveUnknownFieldsPastTheirEnd) {
  const Frame frame{FrameKind::log, {"text"}};
  EXPECT_EQ(frame.at(0), Value("text"));
  EXPECT_TRUE(frame.at(1).is_unknown());
}

TEST(Frames, AreReadAsTheyWereWrittenByteByByte) {
  FrameReader reader;
  std::vector<Frame> frames;
  for (const char byte : bytes_of({FrameKind::log, {"text", 7}}) +
                             bytes_of({FrameKind::done, {}})) {
    reader.add({&byte, 1});
    if (auto frame = reader.next().value())
      frames.push_back(*frame);
  }
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[0].kind, FrameKind::log);
  EXPECT_EQ(frames[0].at(1), Value(7));
  EXPECT_EQ(frames[1].kind, FrameKind::done);
}

TEST(Frames, HaveALargestLength) {
  const auto bytes =
      frame_bytes({FrameKind::log, {std::string(longest_frame, 'x')}});
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().kind, ErrorKind::limit);
  EXPECT_TRUE(
      frame_bytes({FrameKind::log, {std::string(longest_frame - 16, 'x')}}));
}

std::string trouble(std::string bytes) {
  FrameReader reader;
  reader.add(bytes);
  const auto frame = reader.next();
  return frame ? "" : frame.error().message;
}

TEST(Frames, TrustNothing) {
  const auto good = bytes_of({FrameKind::log, {"text"}});
  EXPECT_EQ(trouble(good), "");
  EXPECT_THAT(trouble(std::string(16, '\xff')), HasSubstr("a frame of 1844"));
  auto kind = good;
  kind[8] = 99;
  EXPECT_THAT(trouble(kind), HasSubstr("a kind of frame"));
  auto fields = good;
  fields[9] = 77;
  EXPECT_THAT(trouble(fields), HasSubstr("no type of value"));
  std::string none = good.substr(0, 10);
  none[0] = 2;
  none[9] = 0;
  EXPECT_EQ(trouble(none), "a frame without fields");
  auto more = good + "x";
  ++more[0];
  EXPECT_THAT(trouble(more), HasSubstr("more bytes follow"));
}

} // namespace
} // namespace parlour::adapters
