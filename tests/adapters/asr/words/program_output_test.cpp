#include <gtest/gtest.h>

#include "adapters/asr/words/program_output.hpp"

namespace parlour::adapters::asr {
namespace {

constexpr std::chrono::seconds long_enough(30);

TEST(ProgramOutputTest, IsWhatTheProgramWrites) {
  EXPECT_EQ(program_output({"cat"}, "one\ntwo\n", long_enough), "one\ntwo\n");
  const std::string much(1'000'000, 'x');
  EXPECT_EQ(program_output({"cat"}, much, long_enough), much);
}

TEST(ProgramOutputTest, IsNothingWithoutSuccess) {
  EXPECT_FALSE(program_output({"no-such-program"}, "", long_enough));
  EXPECT_FALSE(program_output({"false"}, "", long_enough));
  EXPECT_FALSE(program_output({}, "", long_enough));
}

TEST(ProgramOutputTest, EndsAProgramThatHangs) {
  EXPECT_FALSE(
      program_output({"sleep", "1000"}, "", std::chrono::milliseconds(50)));
}

} // namespace
} // namespace parlour::adapters::asr
