#include <sstream>

#include <gtest/gtest.h>

#include "tools/parlour/conversation_test/report.hpp"

namespace parlour::tools {
namespace {

const ConversationResult passed{"a", "a.txt", {}, {"U: x"}, {"seen"}, 0};
const ConversationResult failed{"b",
                                "dialogues/b.txt",
                                Failure{3, "R: Yes.", "R: No."},
                                {"U: Well?", "R: No."},
                                {"message  x", "slot  y"},
                                0};

constexpr const char* failure = "FAILED dialogues/b.txt:3:\n"
                                "    U: Well?\n"
                                "    R: No.\n"
                                "  expected: R: Yes.\n"
                                "  found:    R: No.\n";

TEST(Report, tells_failures_only) {
  std::ostringstream out;
  print_failures(out, {passed, failed}, false);
  EXPECT_EQ(out.str(), failure);
  EXPECT_EQ(failure_text(passed), "");
}

TEST(Report, shows_the_trace_of_failures_where_wanted) {
  std::ostringstream out;
  print_failures(out, {passed, failed}, true);
  EXPECT_EQ(out.str(), std::string(failure) + "  | message  x\n  | slot  y\n");
}

TEST(Report, counts) {
  std::ostringstream out;
  print_summary(out, {passed, failed, passed});
  EXPECT_EQ(out.str(), "2 of 3 conversations passed\n");
}

} // namespace
} // namespace parlour::tools
