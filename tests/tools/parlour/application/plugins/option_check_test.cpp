#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/application/plugins/option_check.hpp"

namespace parlour::tools {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> mistakes(const Options& given) {
  const PluginDescription plugin = {
      .name = "Voice",
      .roles = {"TTS"},
      .sentence = "speaks",
      .options = {{"file", "", "what it plays", true},
                  {"rate", "1", "its pace", false, OptionType::number}}};
  std::vector<std::string> texts;
  for (const auto& mistake : option_mistakes("Voice", plugin, given))
    texts.push_back(mistake.text);
  return texts;
}

TEST(OptionCheck, takes_what_is_described) {
  EXPECT_THAT(mistakes({{"file", "a"}, {"rate", "1.5"}}), IsEmpty());
  EXPECT_THAT(mistakes({{"file", "a"}}), IsEmpty());
}

TEST(OptionCheck, tells_all_that_it_does_not_take) {
  EXPECT_THAT(
      mistakes({{"rat", "2"}, {"rate", "fast"}}),
      ElementsAre("Voice: the option 'file' is missing: what it plays",
                  "Voice: the option 'rate' takes a number, not 'fast': its "
                  "pace",
                  "Voice has no option 'rat', did you mean 'rate'?"));
}

TEST(OptionCheck, knows_what_has_a_place) {
  const PluginDescription plugin = {.name = "Voice",
                                    .roles = {},
                                    .sentence = "",
                                    .options = {{"a", "", "", true}}};
  const auto found = option_mistakes("Voice", plugin, {{"b", "1"}});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_FALSE(found[0].is_given);
  EXPECT_TRUE(found[1].is_given);
}

} // namespace
} // namespace parlour::tools
