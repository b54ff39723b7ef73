#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/reference/element_entry.hpp"
#include "tools/parlour/reference/reference.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string told(const std::string& name) {
  const auto text = reference_text(name, {});
  return text ? *text : "error: " + text.error().message;
}

TEST(ElementEntry, TellsOfAnElement) {
  EXPECT_THAT(told("speak"),
              AllOf(StartsWith("<speak>: say it\n"),
                    HasSubstr("stands in  statements\n"),
                    HasSubstr("needed; text or an expression"),
                    HasSubstr("true or false; whether the user may break in"),
                    HasSubstr("language rule "), HasSubstr("  <speak param=")));
  EXPECT_THAT(told("Speak"),
              AllOf(HasSubstr("<speak>"), HasSubstr("TTS understands Speak(")));
  EXPECT_THAT(told("for"), HasSubstr("name from to step?; each in index?"));
  EXPECT_THAT(told("*"), HasSubstr("<NAME> in <component>"));
  EXPECT_THAT(told("console"), HasSubstr("it is refused so far"));
}

TEST(ElementEntry, TellsOfEachElementOfAName) {
  EXPECT_THAT(told("var"),
              AllOf(HasSubstr("<var> in <dialogue>: a session variable"),
                    HasSubstr("<var> among statements: declare"),
                    HasSubstr("<var> in <call>: an argument")));
}

} // namespace
} // namespace parlour::tools
