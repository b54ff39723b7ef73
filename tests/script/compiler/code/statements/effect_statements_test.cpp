#include <gtest/gtest.h>

#include "script/compiler/code/statements/effect_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(EffectStatements, AreTheEffectsOfTheirElements) {
  EXPECT_TRUE(test::has_effect(
      test::compile_declarations("<function name='f'><repeat/></function>"),
      EffectKind::repeat));
  EXPECT_NE(test::finding(R"x(<complete/>)x")
                .find("<complete> has a meaning in a topic only"),
            std::string::npos);
}

} // namespace

} // namespace parlour::script
