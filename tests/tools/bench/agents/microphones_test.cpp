#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/agents/microphones.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Microphones, lose_nothing) {
  std::ostringstream out;
  EXPECT_TRUE(audio_row({1, "audio", 20, 1}, out)) << out.str();
  EXPECT_THAT(out.str(), AllOf(HasSubstr("2500 frames of 640 bytes; lost 0"),
                               HasSubstr("audio by zeromq")));
}

} // namespace
} // namespace parlour::tools
