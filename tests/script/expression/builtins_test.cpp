#include <set>

#include <gtest/gtest.h>

#include "script/expression/builtins.hpp"

namespace parlour::script {

namespace {

TEST(Builtins, AreFoundByName) {
  const auto index = builtin_index("substring");
  ASSERT_TRUE(index);
  EXPECT_STREQ(builtin(*index).name, "substring");
  EXPECT_EQ(builtin(*index).minimum, 2);
  EXPECT_FALSE(is_builtin("Substring"));
}

TEST(Builtins, EachHasOneRowAndASentence) {
  std::set<std::string> names;
  for (const auto& name : builtin_names()) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_NE(std::string(builtin(*builtin_index(name)).sentence), "");
  }
}

} // namespace

} // namespace parlour::script
