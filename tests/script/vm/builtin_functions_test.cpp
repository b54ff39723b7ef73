#include <set>

#include <gtest/gtest.h>

#include "script/expression/builtins.hpp"
#include "script/vm/builtin_functions.hpp"

namespace parlour::script {

namespace {

TEST(BuiltinFunctions, EachNameHasOneOfItsOwn) {
  std::set<BuiltinFunction> functions;
  for (const auto& name : builtin_names()) {
    const auto function = builtin_function(*builtin_index(name));
    ASSERT_NE(function, nullptr) << name;
    EXPECT_TRUE(functions.insert(function).second) << name;
  }
}

} // namespace

} // namespace parlour::script
