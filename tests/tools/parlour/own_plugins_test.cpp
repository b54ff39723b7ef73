// The built-in plug-ins pass the conformance tests of their roles, with the
// options that our applications give them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/plugin/conformance.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tools/parlour/application/application.hpp"

namespace parlour::tools {
namespace {

class OwnPluginsTest : public testing::TestWithParam<const char*> {};

TEST_P(OwnPluginsTest, conform) {
  const auto config = test::source_path("config");
  const auto folder = config + "/apps/" + GetParam();
  const auto application = load_application(folder, config + "/platform");
  EXPECT_FALSE(application.composition.components.empty());
  for (const auto& component : application.composition.components) {
    const test::TemporaryFolder data;
    EXPECT_THAT(conformance_errors(component.factory,
                                   {component.options, Milliseconds(2'000),
                                    data.path().string(), folder}),
                testing::IsEmpty())
        << component.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Applications, OwnPluginsTest,
                         testing::Values("receptionist", "butler", "smart-home",
                                         "hotel", "library", "hospital"));

} // namespace
} // namespace parlour::tools
