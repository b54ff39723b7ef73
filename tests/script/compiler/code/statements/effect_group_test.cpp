#include <gtest/gtest.h>

#include "script/compiler/code/statements/effect_group.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(EffectGroup, ReadsDurationsAndNames) {
  EXPECT_EQ(test::finding("<wait for='2s'/>"), "");
  EXPECT_NE(test::finding(R"x(<push state="Nowhere"/>)x")
                .find("there is no state 'Nowhere'"),
            std::string::npos);
}

} // namespace

} // namespace parlour::script
