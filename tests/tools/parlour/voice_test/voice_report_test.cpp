#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/voice_test/voice_report.hpp"

namespace parlour::tools {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

Row row(const std::string& heard, const std::string& answer) {
  return {3, {"two"}, {heard}, {}, {answer}, {{300ms, 20ms, 5ms}}};
}

VoiceResult result(const std::string& heard, const std::string& answer) {
  return {"x.txt", "rms", {row("", "Two.")}, {row(heard, answer)}, ""};
}

std::string rows(const std::vector<VoiceResult>& results, bool all = false) {
  std::ostringstream out;
  print_rows(out, results, all);
  return out.str();
}

TEST(VoiceReport, tells_what_went_otherwise) {
  EXPECT_EQ(rows({result("two", "Two.")}), "");
  EXPECT_EQ(rows({result("too", "Too.")}), "x.txt:3: by rms\n"
                                           "  said       two\n"
                                           "  heard      too\n"
                                           "  answered   Too.\n"
                                           "    by text  Two.\n");
}

TEST(VoiceReport, may_tell_all) {
  EXPECT_THAT(
      rows({result("two", "Two.")}, true),
      HasSubstr("  time       300 ms until it was over, 20 ms waited, 5 "
                "ms computed\n"));
}

TEST(VoiceReport, names_what_was_not_held) {
  EXPECT_EQ(rows({{"x.txt", "rms", {}, {}, "no voice"}}),
            "x.txt: not held by voice: no voice\n");
}

TEST(VoiceReport, has_a_line_for_each_voice) {
  std::ostringstream out;
  print_scores(out, {result("two", "Two."), result("too", "Too.")},
               {{"rms"}, {NoiseWish::Kind::babble, 20}, false, 1});
  EXPECT_EQ(
      out.str(),
      "voice      noise      words   wrong  sub  ins  del  turns "
      "understood answered  latency p50    p95\n"
      "rms        babble@20      2  50.0 %    1    0    0      2    100.0 "
      "%   50.0 %       325 ms 325 ms\n");
}

TEST(VoiceReport, all_is_well_if_something_went_as_by_text) {
  EXPECT_TRUE(all_as_by_text({result("two", "Two.")}));
  EXPECT_FALSE(all_as_by_text({result("too", "Too.")}));
  EXPECT_FALSE(all_as_by_text({}));
  auto cut_short = result("two", "Two.");
  cut_short.found.clear();
  EXPECT_FALSE(all_as_by_text({cut_short}));
}

} // namespace
} // namespace parlour::tools
