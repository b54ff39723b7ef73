#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tools/parlour/application/plugins/module_names.hpp"

namespace parlour::tools {
namespace {

TEST(ModuleNames, are_the_same_by_role_alias_and_component) {
  Composition composition;
  composition.components.push_back({"Desk", *find_plugin("LogTaxi"), {}, {}});
  const ModuleNames names(composition);
  EXPECT_TRUE(names.same("Taxi", "Desk"));
  EXPECT_TRUE(names.same("Desk", "Taxi"));
  EXPECT_TRUE(names.same("Record", "Microphone"));
  EXPECT_FALSE(names.same("SMS", "Desk"));
  EXPECT_EQ(role_aliases().at("Record"), "Microphone");
}

} // namespace
} // namespace parlour::tools
