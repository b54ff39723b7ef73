#include <gtest/gtest.h>

#include "script/compiler/code/body_compiler.hpp"
#include "tests/script/recording_host.hpp"
#include "tests/script/snippets.hpp"

namespace parlour::script {

namespace {

class BodyCompilerTest : public testing::Test {
protected:
  Attribute attribute(const std::string& value) {
    return {"expr", value, {0, 1, 1}, {0, 1, 7}};
  }
  Value run(CodeId code, std::vector<Value> arguments = {}) {
    Interpreter interpreter(std::make_shared<const Program>(program));
    auto value = interpreter.evaluate(code, std::move(arguments), {}, host);
    EXPECT_TRUE(value) << (value ? "" : value.error().message);
    return value ? *value : Value();
  }

  test::RecordingHost host;
  Program program;
  Names names;
  Findings findings;
  BodyContext context;
};

TEST_F(BodyCompilerTest, AnExpressionIsAFunctionOfItsParameters) {
  BodyCompiler compiler(program, names, findings);
  const auto code =
      compiler.expression(attribute("a * 10 + b"), context, {"a", "b"});
  EXPECT_EQ(run(code, {Value(4), Value(2)}), Value(42));
}

TEST_F(BodyCompilerTest, TextEmbedsExpressions) {
  BodyCompiler compiler(program, names, findings);
  EXPECT_EQ(run(compiler.text("{x}!", {0, 1, 1}, context, {"x"}), {Value(1)}),
            Value("1!"));
  EXPECT_EQ(run(compiler.text_or_expression(attribute("24/7"), context)),
            Value("24/7"));
}

TEST_F(BodyCompilerTest, AFindingStandsWhereTheMistakeIs) {
  findings.add_file("a.xml");
  BodyCompiler compiler(program, names, findings);
  compiler.expression(attribute("1 + nobody"), context);
  ASSERT_EQ(findings.all().size(), 1u);
  EXPECT_EQ(findings.all()[0].place, (SourceLocation{"a.xml", 1, 11}));
}

TEST_F(BodyCompilerTest, SomeChildrenCanBeLeftOut) {
  findings.add_file("a.xml");
  const auto tree = test::tree_of("<step><print param='a'/><Exit/></step>");
  BodyCompiler compiler(program, names, findings);
  run(compiler.body(tree, context, {}, {"exit"}));
  EXPECT_EQ(host.effects.size(), 1u);
  EXPECT_TRUE(findings.all().empty());
}

} // namespace

} // namespace parlour::script
