#include <gmock/gmock.h>

#include "adapters/nlu/understand/explanation.hpp"
#include "tests/adapters/nlu/stages.hpp"

namespace parlour::adapters::nlu::test {
namespace {

using testing::Contains;
using testing::StartsWith;

std::vector<std::string> explained(const std::string& text) {
  const Stages stages(sample_grammar, text);
  const auto chains =
      best_chains(stages.islands, stages.utterance.size(), stages.context);
  const auto acts = build_acts(chains.at(0), stages.utterance, stages.schema,
                               stages.context, 0.4);
  return Explanation(stages.utterance, stages.spans, stages.schema)
      .lines(stages.islands, chains, acts);
}

TEST(Explanation, SaysWhatBecameOfTheWords) {
  const auto lines = explained("er please is there a cofee shop, Gladys");
  EXPECT_EQ(lines.at(0), "tokens please(filler) is there a cofee(?) shop(?) "
                         "gladys(?)");
  EXPECT_THAT(lines, Contains(testing::AllOf(
                         StartsWith("island "),
                         testing::HasSubstr("\"is there a cofee shop\" "
                                            "<g.ask> act=request "
                                            "Category=\"cofee shop\"(0."))));
  EXPECT_THAT(lines, Contains(StartsWith("way ")));
  EXPECT_THAT(lines, Contains(StartsWith("  Facility ")));
  EXPECT_THAT(lines.back(), StartsWith("act "));
  EXPECT_THAT(lines.back(), testing::HasSubstr("coffee shop"));
}

TEST(Explanation, SaysThatNothingWasUnderstood) {
  EXPECT_THAT(explained("zig"),
              testing::ElementsAre("tokens zig(?)", "way 0.00:"));
}

TEST(Explanation, StaysShort) {
  std::string text;
  for (int copy = 0; copy < 200; ++copy)
    text += "is there a bank ";
  const auto lines = explained(text);
  EXPECT_EQ(
      std::ranges::count_if(
          lines, [](const auto& line) { return line.starts_with("island "); }),
      20);
  EXPECT_THAT(lines[0], testing::HasSubstr("(the rest is not looked at)"));
}

} // namespace
} // namespace parlour::adapters::nlu::test
