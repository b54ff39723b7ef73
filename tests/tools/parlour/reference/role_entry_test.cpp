#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/reference/reference.hpp"
#include "tools/parlour/reference/role_entry.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string told(const std::string& name) {
  const auto text = reference_text(name, {});
  return text ? *text : "error: " + text.error().message;
}

TEST(RoleEntry, TellsOfARole) {
  EXPECT_THAT(
      told("TTS"),
      AllOf(StartsWith("TTS: turns text into speech\n"),
            HasSubstr("Speak(text, utterance, interruptible?); always answer"),
            HasSubstr("Finished(utterance); ends a request"),
            HasSubstr("interruptible: true or")));
  EXPECT_THAT(told("Record"), StartsWith("Microphone: "));
}

} // namespace
} // namespace parlour::tools
