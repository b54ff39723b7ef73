#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/reference/entry_text.hpp"
#include "tools/parlour/reference/reference.hpp"

namespace parlour::tools {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string told(const std::string& name) {
  const auto text = reference_text(name, {"check"});
  return text ? *text : "error: " + text.error().message;
}

TEST(Reference, FindsWhoHasAnAttributeOrEvent) {
  EXPECT_THAT(told("interrupt"),
              HasSubstr("<speak interrupt>: whether the user may break in"));
  EXPECT_THAT(told("RecognitionResult"),
              HasSubstr("ASR fires RecognitionResult(text, confidence"));
  EXPECT_THAT(told("name"), HasSubstr("<topic name>, <slot name>, "));
}

TEST(Reference, LooksForAWord) {
  EXPECT_THAT(told("silence"),
              AllOf(StartsWith("nothing is called 'silence'; it is spoken of"),
                    HasSubstr("<sessions no-input-after>: silence that")));
}

TEST(Reference, KnowsWhatIsNearest) {
  EXPECT_EQ(told("speek"),
            "error: nothing is called 'speek', did you mean 'speak'?");
  EXPECT_EQ(told("tts"), "error: nothing is called 'tts', did you mean 'TTS'?");
  EXPECT_EQ(told("interupt"),
            "error: nothing is called 'interupt', did you mean 'interrupt'?");
  EXPECT_EQ(told("chekc"),
            "error: nothing is called 'chekc', did you mean 'check'?");
  EXPECT_EQ(told("qqqqqqq"), "error: nothing is called 'qqqqqqq'");
}

TEST(Reference, NeverTellsMoreThanAScreen) {
  auto names = reference_names();
  names.emplace_back("the");
  for (const auto& name : names) {
    const auto text = told(name);
    EXPECT_LE(static_cast<std::size_t>(std::ranges::count(text, '\n')), screen)
        << name;
    EXPECT_THAT(text, testing::Not(HasSubstr("error: "))) << name;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), text_width) << line;
  }
}

} // namespace
} // namespace parlour::tools
