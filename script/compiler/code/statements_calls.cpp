// Calls, returns and errors (language rules 7 and 9).
#include <algorithm>

#include "script/compiler/code/statements.hpp"
#include "script/expression/builtins.hpp"

namespace parlour::script {

// Arguments by position, or named by <var name>.
std::vector<StatementCompiler::Argument>
StatementCompiler::call_arguments(const Element& element,
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

// The plain name of a local or session variable is bound; anything else,
// constants and system variables too, is by value.
void StatementCompiler::argument(const Argument& argument, Register target,
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

// " (who, when)", for those who forgot what the function wants.
std::string parameters_text(const FunctionName* function) {
  std::string text;
  if (function)
    for (const auto& name : function->parameter_names)
      text += (text.empty() ? " (" : ", ") + name;
  return text.empty() ? text : text + ")";
}

} // namespace

void StatementCompiler::call(const Element& element) {
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
  const bool well = b_.findings.all().size() == findings;
  const auto count = arguments.size();
  const std::size_t minimum =
      function ? function->required : builtin(*builtin_at).minimum;
  const std::size_t maximum =
      function ? function->parameters : builtin(*builtin_at).maximum;
  if (well && (count < minimum || count > std::min<std::size_t>(maximum, 255)))
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

void StatementCompiler::call_dynamic(const Element& element,
                                     const Attribute& function) {
  const auto arguments = call_arguments(element, nullptr);
  const auto base = b_.allocate(arguments.size() + 1);
  expressions_.text(source_of(function), base);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    argument(arguments[i], static_cast<Register>(base + 1 + i), true);
  b_.emit(Operation::call_named, base, 0, arguments.size());
  store_result(element.attribute("return"), base);
}

void StatementCompiler::return_(const Element& element) {
  const auto* expression = element.attribute("expr");
  const auto mark = b_.mark();
  if (!expression) {
    end_transactions(0);
    b_.emit(Operation::give_unknown);
    return;
  }
  const auto source = source_of(*expression);
  if (const auto node = expressions_.parse(source)) {
    const auto value = expressions_.any(*node, source);
    end_transactions(0);
    b_.emit(Operation::give_back, value);
  }
  b_.release(mark);
}

void StatementCompiler::throw_(const Element& element) {
  const auto mark = b_.mark();
  const auto value = b_.allocate();
  initial(element, value);
  b_.emit(Operation::raise, value);
  b_.release(mark);
}

// What was emitted since `from` is guarded by `handler`.
void StatementCompiler::catch_errors(std::uint32_t from,
                                     const Element* handler) {
  const auto to = b_.here();
  const auto well = b_.emit(Operation::jump);
  b_.open_scope();
  const auto* name = handler ? handler->attribute("name") : nullptr;
  const auto error_register = b_.declare(name ? name->value : " ");
  b_.alias("_ERROR", error_register);
  b_.code.catches.push_back({from, to, b_.here(), error_register, false});
  if (handler) {
    reached(*handler);
    block(*handler);
  }
  b_.close_scope();
  b_.land(well);
}

void StatementCompiler::try_(const Element& element) {
  const auto from = b_.here();
  block(element, {"catch"});
  if (const auto* handler = element.child("catch"))
    return catch_errors(from, handler);
  b_.findings.add({Severity::warning,
                   {element.position},
                   "<try> needs a <catch>; without one, errors pass on",
                   "catchless-try"});
}

} // namespace parlour::script
