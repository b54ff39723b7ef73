#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/conversation_test/junit.hpp"

namespace parlour::tools {
namespace {

TEST(JUnit, counts_and_escapes) {
  ConversationResult good{"a", "a.txt", {}, {}, {}, 0.5};
  ConversationResult bad{
      "b<",         "b.txt", Failure{3, "R: \"x\"", "R: y\x01"},
      {"U: a & b"}, {},      0.25};
  std::ostringstream out;
  print_junit(out, "app", {good, bad});
  EXPECT_THAT(out.str(),
              testing::HasSubstr("<testsuite name=\"app\" tests=\"2\" "
                                 "failures=\"1\" time=\"0.750\">"));
  EXPECT_THAT(out.str(), testing::HasSubstr("name=\"b&lt;\""));
  EXPECT_THAT(out.str(), testing::HasSubstr("message=\"line 3: R: y?\""));
  EXPECT_THAT(out.str(), testing::HasSubstr("U: a &amp; b"));
}

} // namespace
} // namespace parlour::tools
