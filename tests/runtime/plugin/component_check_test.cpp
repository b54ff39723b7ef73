#include <gmock/gmock.h>

#include "runtime/plugin/component_check.hpp"

namespace parlour {

namespace {

using testing::HasSubstr;

PluginDescription plugin(const char* name, std::vector<std::string> roles) {
  PluginDescription description;
  description.name = name;
  description.roles = std::move(roles);
  return description;
}

TEST(ComponentCheck, LetsComponentsSpeakForThemselvesOnly) {
  const auto telephone = plugin("LogTelephone", {"Telephone"});
  EXPECT_TRUE(check_component("Desk", telephone));
  for (const auto* name :
       {"System", "Session", "ASR", "Record", "*", "a,b", ""})
    EXPECT_EQ(check_component(name, telephone).error().kind,
              ErrorKind::settings)
        << name;
  EXPECT_THAT(check_component("Desk", plugin("P", {"System"})).error().message,
              HasSubstr("'System', which is no role"));
}

TEST(ComponentCheck, WantsAllRolesOfWhatIsReplaced) {
  const auto before = plugin("A", {"Microphone", "VAD"});
  EXPECT_TRUE(check_replacement("Ear", before, plugin("B", {"VAD", "Record"})));
  EXPECT_EQ(
      check_replacement("Ear", before, plugin("B", {"VAD"})).error().message,
      "Ear: it is the Microphone here, which B is not; load B under another "
      "name");
}

} // namespace

} // namespace parlour
