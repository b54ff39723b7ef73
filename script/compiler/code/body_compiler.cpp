// Each body gets a builder of its own; what differs is only which compiler
// fills it: the one of statements for bodies, the one of expressions for single
// values.

#include "script/compiler/code/body_compiler.hpp"

#include "script/compiler/code/statements/branch_statements.hpp"
#include "script/compiler/code/statements/statements.hpp"
#include "script/values/objects.hpp"

namespace parlour::script {

namespace {

// Parameters of the compiler's own, such as `data` of a phrase: always given.
void declare(CodeBuilder& builder, const std::vector<std::string>& parameters) {
  for (const auto& name : parameters)
    builder.declare(name);
  builder.code.parameter_names = parameters;
  builder.code.parameter_count = static_cast<std::uint16_t>(parameters.size());
}

CodeId add(Program& program, Code code) {
  program.code.push_back(std::move(code));
  return static_cast<CodeId>(program.code.size() - 1);
}

} // namespace

BodyCompiler::BodyCompiler(Program& program, const Names& names,
                           Findings& findings)
    : program_(program), names_(names), findings_(findings) {
  if (!program_.pool)
    program_.pool = std::make_shared<ConstantPool>();
}

CodeId BodyCompiler::body(const Element& parent, const BodyContext& context,
                          const std::vector<std::string>& parameters,
                          ElementNames except) {
  CodeBuilder builder(program_, names_, findings_, context);
  builder.at(parent.position);
  declare(builder, parameters);
  StatementCompiler(builder).block(parent, except);
  return add(program_, builder.finish());
}

CodeId BodyCompiler::after_summary(const Element& topic, bool only_if_unsure,
                                   const BodyContext& context) {
  CodeBuilder builder(program_, names_, findings_, context);
  builder.at(topic.position);
  StatementCompiler statements(builder);
  BranchStatements(statements).summary(topic.child("refused"), only_if_unsure);
  if (const auto* filled = topic.child("filled"))
    statements.block(*filled);
  return add(program_, builder.finish());
}

void BodyCompiler::function(const Element& element, CodeId reserved,
                            const BodyContext& context) {
  CodeBuilder builder(program_, names_, findings_, context);
  builder.at(element.position);
  if (builder.code.name.empty())
    builder.code.name = "function " + element.value("name");
  StatementCompiler statements(builder);
  statements.parameters(element);
  statements.block(element, {"param"});
  program_.code[reserved] = builder.finish();
}

namespace {

// Compiles code that computes one value and returns it.
template <class Compile>
CodeId value(Program& program, const Names& names, Findings& findings,
             const BodyContext& context, Position position,
             const std::vector<std::string>& parameters, Compile compile) {
  CodeBuilder builder(program, names, findings, context);
  builder.at(position);
  declare(builder, parameters);
  const auto target = builder.allocate();
  ExpressionCompiler expressions(builder);
  compile(expressions, target);
  builder.emit(Operation::give_back, target);
  return add(program, builder.finish());
}

} // namespace

CodeId BodyCompiler::expression(const Attribute& attribute,
                                const BodyContext& context,
                                const std::vector<std::string>& parameters) {
  return value(program_, names_, findings_, context, attribute.value_position,
               parameters, [&](ExpressionCompiler& compiler, Register target) {
                 compiler.expression(source_of(attribute), target);
               });
}

CodeId BodyCompiler::text_or_expression(const Attribute& attribute,
                                        const BodyContext& context) {
  return value(program_, names_, findings_, context, attribute.value_position,
               {}, [&](ExpressionCompiler& compiler, Register target) {
                 compiler.text_or_expression(source_of(attribute), target);
               });
}

CodeId BodyCompiler::text(const std::string& text, Position position,
                          const BodyContext& context,
                          const std::vector<std::string>& parameters) {
  return value(program_, names_, findings_, context, position, parameters,
               [&](ExpressionCompiler& compiler, Register target) {
                 compiler.text({text, position, true}, target);
               });
}

} // namespace parlour::script
