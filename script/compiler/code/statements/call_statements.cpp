// Calls and returns (language rule 7).
#include "script/compiler/code/statements/call_statements.hpp"

#include <algorithm>

#include "script/compiler/code/statements/transaction_statements.hpp"
#include "script/expression/builtins.hpp"

namespace parlour::script {

// The arguments of a <call> in the order of the parameters, whether they are
// given by position or by name (language rule 7.5). An entry without a position
// is a parameter that was left out.
std::vector<CallStatements::Argument>
CallStatements::call_arguments(const Element& element,
                               const FunctionName* function) {
  std::vector<Argument> arguments;
  for (const auto& child : element.children) {
    if (!child.is("var"))
      continue;
    Argument given{child.attribute("expr"), child.position};
    const auto* name = child.attribute("name");
    if (!name) {
      arguments.push_back(given);
      continue;
    }
    const auto names =
        function ? function->parameter_names : std::vector<std::string>();
    const auto at = std::find(names.begin(), names.end(), name->value);
    if (at == names.end()) {
      error(name->value_position, "there is no parameter '" + name->value +
                                      "'" + did_you_mean(name->value, names));
      continue;
    }
    const auto index = static_cast<std::size_t>(at - names.begin());
    if (arguments.size() <= index)
      arguments.resize(index + 1);
    if (arguments[index].position.line != 0)
      error(child.position,
            "the parameter '" + name->value + "' is given a second time");
    arguments[index] = given;
  }
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (arguments[i].position.line == 0 && i < function->required)
      error(element.position, "the parameter '" + function->parameter_names[i] +
                                  "' has no default; it must be given");
  return arguments;
}

// Language rule 7.3: an argument that is the plain name of a local or session
// variable is bound to it. Everything else is passed by value, also constants
// and system variables.
void CallStatements::argument(const Argument& argument, Register target,
                              bool may_bind) {
  if (argument.position.line == 0)
    return b_.load(target, Box::missing());
  if (!argument.expression)
    return b_.load(target, Box());
  const auto source = source_of(*argument.expression);
  const auto node = expressions_.parse(source);
  if (!node)
    return;
  if (may_bind && node->kind == NodeKind::name) {
    const auto meaning = b_.find(node->text);
    if (meaning.local && !meaning.local->is_constant) {
      b_.emit(Operation::bind_register, target, meaning.local->reg);
      return;
    }
    if (meaning.kind == Meaning::Kind::variable &&
        meaning.index < b_.program.variables.size() &&
        !b_.program.variables[meaning.index].is_constant) {
      b_.emit(Operation::bind_variable, target, meaning.index);
      return;
    }
  }
  expressions_.into(*node, source, target);
}

namespace {

// The parameters in brackets, for messages about a wrong number of arguments.
std::string parameters_text(const FunctionName* function) {
  std::string text;
  if (function)
    for (const auto& name : function->parameter_names)
      text += (text.empty() ? " (" : ", ") + name;
  return text.empty() ? text : text + ")";
}

} // namespace

// Findings about the arguments suppress the one about their number, which would
// only repeat them.
void CallStatements::call(const Element& element) {
  const auto* name = required(element, "function");
  if (!name)
    return;
  if (name->value.find('{') != std::string::npos)
    return call_dynamic(element, *name);
  const auto* function = b_.function(name->value);
  const auto builtin_at = builtin_index(name->value);
  if (!function && !builtin_at) {
    auto candidates = b_.function_names();
    candidates.insert(candidates.end(), builtin_names().begin(),
                      builtin_names().end());
    return error(name->value_position,
                 "there is no function '" + name->value + "'" +
                     did_you_mean(name->value, candidates));
  }
  const auto findings = b_.findings.all().size();
  const auto arguments = call_arguments(element, function);
  const bool ok = b_.findings.all().size() == findings;
  const auto count = arguments.size();
  const std::size_t minimum =
      function ? function->required : builtin(*builtin_at).minimum;
  const std::size_t maximum =
      function ? function->parameters : builtin(*builtin_at).maximum;
  if (ok && (count < minimum || count > std::min<std::size_t>(maximum, 255)))
    error(element.position,
          "'" + name->value + "' takes " + std::to_string(minimum) +
              (minimum == maximum ? "" : " to " + std::to_string(maximum)) +
              (maximum == 1 ? " argument" : " arguments") +
              parameters_text(function) + ", not " + std::to_string(count));
  const auto base = b_.allocate(count ? count : 1);
  for (std::size_t i = 0; i < count; ++i)
    argument(arguments[i], static_cast<Register>(base + i), function);
  b_.at(element.position);
  if (function)
    b_.emit_wide(Operation::call, base, function->code,
                 static_cast<std::uint8_t>(count));
  else
    b_.emit(Operation::call_builtin, base, *builtin_at, base,
            static_cast<std::uint8_t>(count));
  store_result(element.attribute("return"), base);
}

// A function whose name is computed: its arguments can only be checked at run
// time, so all that could be bound are bound.
void CallStatements::call_dynamic(const Element& element,
                                  const Attribute& function) {
  const auto arguments = call_arguments(element, nullptr);
  const auto base = b_.allocate(arguments.size() + 1);
  expressions_.text(source_of(function), base);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    argument(arguments[i], static_cast<Register>(base + 1 + i), true);
  b_.emit(Operation::call_named, base, 0, arguments.size());
  store_result(element.attribute("return"), base);
}

// Open transactions are committed before leaving (language rule 11.3), after
// the result was computed.
void CallStatements::return_(const Element& element) {
  const auto* expression = element.attribute("expr");
  const auto mark = b_.mark();
  if (!expression) {
    TransactionStatements(body_).end(0);
    b_.emit(Operation::give_unknown);
    return;
  }
  const auto source = source_of(*expression);
  if (const auto node = expressions_.parse(source)) {
    const auto value = expressions_.any(*node, source);
    TransactionStatements(body_).end(0);
    b_.emit(Operation::give_back, value);
  }
  b_.release(mark);
}

} // namespace parlour::script
