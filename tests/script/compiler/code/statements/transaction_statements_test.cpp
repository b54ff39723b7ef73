#include <gtest/gtest.h>

#include "script/compiler/code/statements/transaction_statements.hpp"
#include "tests/script/compiler/code/compiled_statements.hpp"

namespace parlour::script {

namespace {

TEST(TransactionStatements, AreCommittedOrRolledBack) {
  const auto outcome = test::compile_declarations(
      "<function name='f'><transaction><return/></transaction></function>");
  ASSERT_TRUE(outcome.program);
  for (const auto kind :
       {EffectKind::begin, EffectKind::commit, EffectKind::rollback})
    EXPECT_TRUE(test::has_effect(outcome, kind));
  EXPECT_NE(test::finding(R"x(<transaction><transaction/></transaction>)x")
                .find("a <transaction> cannot stand in another one"),
            std::string::npos);
}

} // namespace

} // namespace parlour::script
