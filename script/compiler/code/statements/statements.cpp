// The dispatch from elements to the classes that compile them, blocks, and the
// parameters of functions.

#include "script/compiler/code/statements/statements.hpp"

#include <algorithm>

#include "script/compiler/code/statements/branch_statements.hpp"
#include "script/compiler/code/statements/call_statements.hpp"
#include "script/compiler/code/statements/detached_statements.hpp"
#include "script/compiler/code/statements/effect_statements.hpp"
#include "script/compiler/code/statements/error_statements.hpp"
#include "script/compiler/code/statements/loop_statements.hpp"
#include "script/compiler/code/statements/message_statements.hpp"
#include "script/compiler/code/statements/query_statements.hpp"
#include "script/compiler/code/statements/transaction_statements.hpp"
#include "script/compiler/code/statements/variable_statements.hpp"
#include "script/source/by_name.hpp"

namespace parlour::script {

namespace {

using Compile = void (*)(OpenBody& body, const Element& element);

// Calls the method of a group that is made for the statement.
template <class Group, void (Group::*method)(const Element&)>
void with(OpenBody& body, const Element& element) {
  Group group(body);
  (group.*method)(element);
}

using Variables = VariableStatements;
using Branches = BranchStatements;
using Loops = LoopStatements;

// Every other element is an effect that is no more than its operands.
Compile find(std::string_view name) {
  static const ByName<Compile> all{
      {"var", with<Variables, &Variables::declare_variable>},
      {"const", with<Variables, &Variables::declare_constant>},
      {"set", with<Variables, &Variables::set>},
      {"object", with<Variables, &Variables::object>},
      {"getlist", with<Variables, &Variables::get_list>},
      {"append", with<Variables, &Variables::append>},
      {"if", with<Branches, &Branches::if_>},
      {"switch", with<Branches, &Branches::switch_>},
      {"confirm", with<Branches, &Branches::confirm>},
      {"for", with<Loops, &Loops::for_>},
      {"while", with<Loops, &Loops::while_>},
      {"break", with<Loops, &Loops::break_>},
      {"continue", with<Loops, &Loops::continue_>},
      {"call", with<CallStatements, &CallStatements::call>},
      {"return", with<CallStatements, &CallStatements::return_>},
      {"try", with<ErrorStatements, &ErrorStatements::try_>},
      {"throw", with<ErrorStatements, &ErrorStatements::throw_>},
      {"fire", with<MessageStatements, &MessageStatements::fire>},
      {"post", with<MessageStatements, &MessageStatements::post>},
      {"request", with<MessageStatements, &MessageStatements::request>},
      {"timer", with<DetachedStatements, &DetachedStatements::timer>},
      {"transit", with<DetachedStatements, &DetachedStatements::transit>},
      {"querydb", with<QueryStatements, &QueryStatements::query>},
      {"transaction",
       with<TransactionStatements, &TransactionStatements::transaction>},
  };
  const auto there = all.find(name);
  return there == all.end() ? with<EffectStatements, &EffectStatements::effect>
                            : there->second;
}

} // namespace

void StatementCompiler::block(const Element& parent, ElementNames except) {
  builder.open_scope();
  for (const auto& child : parent.children)
    if (std::none_of(except.begin(), except.end(),
                     [&](auto name) { return child.is(name); }))
      statement(child);
  builder.close_scope();
}

void StatementCompiler::body_apart(const Element& parent, CodeBuilder& into) {
  StatementCompiler(into).block(parent);
}

// All instructions of a statement get its position, unless a part sets its own.
void StatementCompiler::statement(const Element& element) {
  builder.at(element.position);
  find(element.name)(*this, element);
}

// All parameters get registers first; then each default is computed if its
// argument is missing, and the parameter becomes visible. So a default sees the
// parameters before it only (language rule 7.4), and `code.body` is behind the
// defaults.
void StatementCompiler::parameters(const Element& function) {
  std::vector<const Element*> all;
  for (const auto& child : function.children)
    if (child.is("param"))
      all.push_back(&child);
  auto& code = builder.code;
  code.parameter_count = static_cast<std::uint16_t>(all.size());
  for (const auto* each : all) {
    const auto* name = each->attribute("name");
    code.required_count = static_cast<std::uint16_t>(code.required_count +
                                                     !each->attribute("expr"));
    code.parameter_names.push_back(name ? name->value : "");
  }
  // Arguments arrive in the first registers, so these are the parameters'.
  const auto first = builder.allocate(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& name = code.parameter_names[i];
    const auto target = static_cast<Register>(first + i);
    const auto* initial = all[i]->attribute("expr");
    builder.at(all[i]->position);
    if (builder.in_block(name))
      builder.findings.error(all[i]->position,
                             "a second parameter named '" + name + "'");
    if (initial) {
      const auto given = builder.emit(Operation::jump_if_given, target);
      expressions.expression(source_of(*initial), target);
      builder.land(given);
    } else if (i > 0 && all[i - 1]->attribute("expr")) {
      builder.findings.error(all[i]->position,
                             "parameters with a default come last");
    }
    builder.declare_parameter(name, target);
  }
  code.body = builder.here();
}

} // namespace parlour::script
