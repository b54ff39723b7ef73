// All inputs as data; that each leads to the same again is tested by every
// World (conversation_world.cpp).
#include <gtest/gtest.h>

#include "script/dialogue/inputs/replay.hpp"
#include "tests/script/dialogue/saved/round_trip.hpp"

namespace parlour::dialogue {
namespace {

std::vector<SessionInput> all_inputs() {
  Message message;
  message.source = "ASR";
  message.command = "RecognitionResult";
  message.params = {"hello", 1};
  return {input::Begun{},
          input::Received{std::make_shared<const Message>(message)},
          input::Stepped{},
          input::FrameApplied{},
          input::QueryAnswered{3, Value(7)},
          input::FileAnswered{4, fail(ErrorKind::file, "no such file")},
          input::ComponentAnswered{5, fail(ErrorKind::refused, "not there")},
          input::SocketOpened{6, {}},
          input::SocketClosed{6},
          input::TimerFired{8},
          input::OutputFinished{9, false},
          input::Closed{},
          input::Resumed{}};
}

TEST(SessionInput, EachIsReadAsItWasWritten) {
  const auto program = small_program();
  const auto all = all_inputs();
  ASSERT_EQ(all.size(), std::variant_size_v<SessionInput>);
  for (std::size_t kind = 0; kind < all.size(); ++kind) {
    const TimedInput input{1'000, all[kind]};
    const auto bytes = to_bytes(*program, input);
    const auto again = read_input(program, bytes);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->now, 1'000);
    EXPECT_EQ(again->what.index(), kind);
    EXPECT_EQ(to_bytes(*program, *again), bytes);
  }
}

TEST(SessionInput, KeepsWhatAnErrorSaid) {
  const auto program = small_program();
  const auto again = read_input(
      program,
      to_bytes(*program, {5, input::ComponentAnswered{
                                 5, fail(ErrorKind::refused, "not there")}}));
  const auto& outcome = std::get<input::ComponentAnswered>(again->what).outcome;
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, ErrorKind::refused);
  EXPECT_EQ(outcome.error().message, "not there");
}

TEST(SessionInput, HasAName) {
  EXPECT_EQ(name_of(input::Begun{}), "begin");
  EXPECT_EQ(name_of(input::TimerFired{}), "timer");
  EXPECT_EQ(name_of(input::Resumed{}), "resume");
}

TEST(SessionInput, DamagedBytesAreAnError) {
  const auto program = small_program();
  for (const auto& input : all_inputs()) {
    const auto bytes = to_bytes(*program, {1, input});
    for (std::size_t size = 0; size < bytes.size(); ++size)
      EXPECT_FALSE(read_input(program, bytes.substr(0, size)));
    EXPECT_FALSE(read_input(program, bytes + "x"));
  }
  EXPECT_FALSE(read_input(program, std::string("\2\77", 2)));
}

} // namespace
} // namespace parlour::dialogue
