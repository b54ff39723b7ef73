#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/description_check.hpp"

namespace parlour {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

PluginDescription good() {
  PluginDescription plugin;
  plugin.name = "EchoTTS";
  plugin.roles = {"TTS"};
  plugin.sentence = "says what it is to say";
  plugin.options = {
      {"pace", "2s", "how long it takes", false, OptionType::duration}};
  return plugin;
}

TEST(DescriptionCheck, FindsNothingInAGoodOne) {
  EXPECT_THAT(check_description(good()), IsEmpty());
}

TEST(DescriptionCheck, MissesWhatEachHas) {
  EXPECT_THAT(check_description({}),
              ElementsAre("it is described without a name",
                          "it is described without a sentence",
                          "it is described without a role, and without "
                          "commands of its own"));
}

TEST(DescriptionCheck, KnowsRoles) {
  auto plugin = good();
  plugin.roles = {"TSS", "System"};
  EXPECT_THAT(check_description(plugin),
              ElementsAre("there is no role 'TSS'",
                          HasSubstr("'System' is no role, but a source")));
}

TEST(DescriptionCheck, LooksAtOptions) {
  auto plugin = good();
  plugin.options[0].fallback = "soon";
  plugin.options.push_back({"pace", "", ""});
  EXPECT_THAT(check_description(plugin),
              ElementsAre(HasSubstr("its default does not fit: the option "
                                    "'pace' takes a time"),
                          "the option 'pace' is described twice",
                          "the option 'pace' has no name or no sentence"));
}

} // namespace
} // namespace parlour
