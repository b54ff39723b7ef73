#include <gtest/gtest.h>

#include "script/compiler/code/expressions/expression_compiler.hpp"

namespace parlour::script {

namespace {

class ExpressionCompilerTest : public testing::Test {
protected:
  ExpressionCompilerTest() {
    program.pool = std::make_shared<ConstantPool>();
    findings.add_file("a.xml");
  }
  bool is_expression(const std::string& text) {
    return expressions.decide({text, {0, 1, 1}}) != nullptr;
  }

  Program program;
  Names names;
  Findings findings;
  CodeBuilder builder{program, names, findings, {}};
  ExpressionCompiler expressions{builder};
};

TEST_F(ExpressionCompilerTest, DecidesByWhatIsDeclared) {
  EXPECT_FALSE(is_expression("visitor"));
  builder.declare("visitor");
  EXPECT_TRUE(is_expression("visitor"));
  EXPECT_TRUE(is_expression("_LPARAM1_"));
  EXPECT_TRUE(is_expression("now()"));
  EXPECT_FALSE(is_expression("nobody()"));
  EXPECT_FALSE(is_expression("select staff_name from rr_staff"));
  EXPECT_FALSE(is_expression("007"));
}

TEST_F(ExpressionCompilerTest, TextWithoutEmbeddingIsOnePart) {
  EXPECT_EQ(expressions.split_text({"a {{b}} {not one", {}}).size(), 1u);
  EXPECT_EQ(expressions.split_text({"a{1}b{2}", {}}).size(), 4u);
}

TEST_F(ExpressionCompilerTest, AComparisonJumpsInOneInstruction) {
  builder.declare("n");
  const auto node = parse_expression("n lt 2").node;
  std::vector<Label> labels;
  expressions.jump(*node, {"n lt 2", {}}, false, labels);
  EXPECT_EQ(builder.code.instructions.size(), 1u);
}

} // namespace

} // namespace parlour::script
