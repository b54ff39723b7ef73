#include <cstdlib>
#include <map>

#include <gtest/gtest.h>

#include "runtime/base/outside/environment.hpp"

namespace parlour {
namespace {

TEST(Environment, HasVariablesThatSaySomething) {
  setenv("PARLOUR_TEST_ENVIRONMENT", "something", 1);
  EXPECT_EQ(environment_variable("PARLOUR_TEST_ENVIRONMENT"), "something");
  setenv("PARLOUR_TEST_ENVIRONMENT", "", 1);
  EXPECT_EQ(environment_variable("PARLOUR_TEST_ENVIRONMENT"), std::nullopt);
  unsetenv("PARLOUR_TEST_ENVIRONMENT");
  EXPECT_EQ(environment_variable("PARLOUR_TEST_ENVIRONMENT"), std::nullopt);
}

TEST(Environment, NamesFoldersOfTheUser) {
  const auto folder = [](const std::map<std::string, std::string>& set) {
    return user_folder(
        [&](const std::string& name) -> std::optional<std::string> {
          const auto found = set.find(name);
          return found == set.end() ? std::nullopt
                                    : std::optional(found->second);
        },
        "XDG_CACHE_HOME", ".cache");
  };
  EXPECT_EQ(folder({{"HOME", "/home/ada"}}), "/home/ada/.cache");
  EXPECT_EQ(folder({{"HOME", "/home/ada"}, {"XDG_CACHE_HOME", "/cache"}}),
            "/cache");
  EXPECT_EQ(folder({{"HOME", "/home/ada"}, {"XDG_CACHE_HOME", "cache"}}),
            "/home/ada/.cache");
  EXPECT_EQ(folder({{"HOME", "home"}}), "");
  EXPECT_EQ(folder({}), "");
}

} // namespace
} // namespace parlour
