#include <thread>

#include <gtest/gtest.h>

#include "tools/parlour/talk/hearing.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;

class HearingTest : public testing::Test {
protected:
  void hears(const char* source, const char* command, Hearing::Moment when) {
    Message message;
    message.source = source;
    message.command = command;
    hearing.take(message, when);
  }

  const Hearing::Moment start{1h};
  Hearing hearing{{"FileMicrophone", "Ear"}, 4s};
};

TEST_F(HearingTest, AMicrophoneIsHeardForEver) {
  hears("AlsaMicrophone", "BufferFull", start);
  EXPECT_FALSE(hearing.is_over(start + 1h));
}

TEST_F(HearingTest, AFileIsOverOnceAllIsQuiet) {
  hears("FileMicrophone", "FileEnded", start);
  EXPECT_FALSE(hearing.is_over(start + 3999ms));
  hears("FileSpeaker", "Finished", start + 3s); // the robot still spoke
  EXPECT_FALSE(hearing.is_over(start + 6999ms));
  EXPECT_TRUE(hearing.is_over(start + 7s));
}

// Settings may call it as they like.
TEST_F(HearingTest, AMicrophoneMayHaveAnotherName) {
  hears("Ear", "FileEnded", start);
  EXPECT_TRUE(hearing.is_over(start + 4s));
}

TEST_F(HearingTest, OnlyTheMicrophonesEndCounts) {
  hears("Somebody", "FileEnded", start);
  EXPECT_FALSE(hearing.is_over(start + 1h));
}

// Returns although no file ends.
TEST_F(HearingTest, ASignalEndsTheWait) {
  std::thread signal([&] { hearing.end(); });
  hearing.wait();
  signal.join();
  EXPECT_TRUE(hearing.is_over(start));
}

} // namespace
} // namespace parlour::tools
