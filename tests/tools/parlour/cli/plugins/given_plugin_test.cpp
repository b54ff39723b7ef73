#include <gmock/gmock.h>

#include "tools/parlour/cli/plugins/given_plugin.hpp"

namespace parlour::tools {
namespace {

using testing::HasSubstr;

PluginDescription described() {
  PluginDescription plugin;
  plugin.name = "Echo";
  plugin.options = {{"voice", "", "how it speaks"}};
  return plugin;
}

TEST(GivenPlugin, is_a_name_or_a_file) {
  const auto places = process_places();
  EXPECT_TRUE(given_plugin(places, "LogRobot"));
  EXPECT_FALSE(given_plugin(places, "LogRobt"));
  const auto missing = given_plugin(places, "none.so");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("none.so"));
}

TEST(GivenOptions, are_pairs_that_the_plugin_knows) {
  EXPECT_EQ(given_options({"voice=a=b"}, described())->at("voice"), "a=b");
  EXPECT_THAT(given_options({"voice"}, described()).error().message,
              HasSubstr("lacks its '=value'"));
  EXPECT_THAT(given_options({"sound=1"}, described()).error().message,
              HasSubstr("sound"));
}

} // namespace
} // namespace parlour::tools
