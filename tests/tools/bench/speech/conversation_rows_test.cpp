#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/bench/speech/conversation_rows.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

Row row(const std::string& said, const std::string& heard,
        const std::string& understood) {
  return {1, {said}, {heard}, {understood}, {}, {}};
}

TEST(ConversationRows, are_told_with_a_baseline) {
  const std::vector<VoiceResult> results{
      {"a.txt",
       "rms",
       {row("yes please", "", "confirm"), row("no", "", "deny"),
        row("yes", "", "confirm")},
       {row("yes please", "yes peas", "confirm"), row("no", "no", "deny"),
        row("yes", "", "nothing")},
       ""}};
  EXPECT_NEAR(always_the_same(results), 66.7, 0.1);
  std::ostringstream out;
  print_conversations({"clean", {}, 2, 95}, {{"rms"}, {}, false, 1}, results,
                      out);
  EXPECT_THAT(out.str(), HasSubstr("rms: 3 turns, 4 words; word errors 50.0 % "
                                   "(bar 2: missed), understood as by text "
                                   "66.7 % (bar 95: missed)"));
  EXPECT_THAT(out.str(), HasSubstr("most frequent turn is right in 66.7 %"));
}

TEST(Reaction, leaves_the_pause_out) {
  const std::vector<Latency> latencies{{300ms, 20ms, 30ms}, {700ms, 0ms, 10ms}};
  EXPECT_EQ(reaction(latencies, 95), 50ms);
  EXPECT_EQ(reaction({}, 95), 0ms);
}

} // namespace
} // namespace parlour::tools
