// Findings about expressions: the nearest right name, or what the author may
// have meant.
#include <algorithm>

#include "script/compiler/code/expressions/expression_compiler.hpp"
#include "script/expression/builtins.hpp"
#include "script/expression/common_mistakes.hpp"
#include "script/expression/expression_mistakes.hpp"

namespace parlour::script {

namespace {

// Whether the topic around has such a slot.
bool is_slot(const std::string& name, const BodyContext& context) {
  return context.topic && context.topic->slot(name) != no_id;
}

// Whether a session variable of this name exists although it is not visible:
// code of <routes> and <phrases> sees none of them.
bool is_of_session(const std::string& name, const Program& program) {
  return std::ranges::any_of(program.variables, [&](const auto& variable) {
    return variable.name == name;
  });
}

std::string of_session(const std::string& quoted, const BodyContext& context) {
  return quoted +
         (context.handles_message
              ? " is a variable of a session, and this sees the message and "
                "constants (<const>) only"
              : " is a variable of a session, and a phrase sees act, topic, "
                "slot, data and constants (<const>) only; what the script says "
                "can give it: <say act=\"…\" data=\"…\"/>");
}

} // namespace

// The rules of script/expression know the mistakes; here they get the names
// that are visible.
void ExpressionCompiler::report(const Source& source, const Parsed& parsed) {
  const auto known = [this](const std::string& name) {
    return is_declared(name) || name == "this";
  };
  for (auto& mistake : find_mistakes(source.text, parsed, source.wanted, known))
    b_.findings.add({Severity::error,
                     source.spot(mistake.offset, mistake.length),
                     std::move(mistake.message), "expression",
                     std::move(mistake.replacement)});
}

void ExpressionCompiler::error(const Node& node, const Source& source,
                               std::string message,
                               std::optional<std::string> replacement) {
  b_.findings.add({Severity::error, source.spot(node.offset, node.text.size()),
                   std::move(message), "expression", std::move(replacement)});
}

// Explains an unknown name. The explanations are tried from the most certain to
// the least: a slot without `this`, a function without brackets, another case,
// a word of another language, a similar name, a text without quotes.
void ExpressionCompiler::unknown_name(const Node& node, const Source& source) {
  const auto& name = node.text;
  const auto quoted = "'" + name + "'";
  if (!explains(b_.findings))
    return error(node, source, quoted + " is not declared");
  const auto known = b_.visible_names();
  if (name == "this")
    return error(node, source, "'this' is followed by a slot: this.Name");
  if (is_of_session(name, b_.program))
    return error(node, source, of_session(quoted, b_.context));
  if (is_slot(name, b_.context))
    return error(node, source,
                 quoted + " is not declared; the topic's slot is this." + name,
                 "this." + name);
  if (b_.function(name) || is_builtin(name))
    return error(node, source, quoted + " is a function; call it with (…)");
  if (auto right = same_but_case(name, known); !right.empty())
    return error(node, source,
                 quoted + " is not declared, did you mean '" + right +
                     "'? Small and capital letters differ",
                 right);
  if (const auto* mistake = find_mistake(MistakePlace::operand, name))
    return error(node, source,
                 quoted + " is not declared; it is written '" +
                     std::string(mistake->meant) + "'",
                 std::string(mistake->meant));
  const auto near = did_you_mean(name, known);
  if (!near.empty())
    return error(node, source, quoted + " is not declared" + near);
  if (source.wanted == Wanted::value && is_text(source))
    return b_.findings.add(
        {Severity::error, source.spot(0, source.text.size()),
         "this reads like text, and an expression is expected; a text stands "
         "in quotes: " +
             quoted_text(source.text) + ", and a variable is declared by <var>",
         "expression"});
  error(
      node, source,
      quoted + " is not declared; a text stands in quotes: " +
          (source.wanted == Wanted::text ? quoted_text(source.text) : quoted) +
          ", and a variable is declared by <var name=\"" + name +
          "\" expr=\"…\"/>");
}

// Whether the whole expression consists of words, none of which is known.
bool ExpressionCompiler::is_text(const Source& source) const {
  return reads_like_text(source.text, [this](const std::string& word) {
    return is_declared(word) || word == "this";
  });
}

// For the target of a <set>, declaring it is the most likely intention.
void ExpressionCompiler::unknown_target(const Node& node,
                                        const Source& source) {
  if (!explains(b_.findings))
    return unknown_name(node, source);
  const auto known = b_.visible_names();
  if (!did_you_mean(node.text, known).empty() || node.text == "this" ||
      b_.function(node.text) || is_slot(node.text, b_.context) ||
      is_of_session(node.text, b_.program))
    return unknown_name(node, source);
  error(node, source,
        "'" + node.text + "' is not declared; <var name=\"" + node.text +
            "\"/> before this declares it");
}

// Like unknown_name: another case, the name in another language, a similar one.
void ExpressionCompiler::unknown_function(const Node& node,
                                          const Source& source) {
  const auto quoted = "'" + node.text + "'";
  if (!explains(b_.findings))
    return error(node, source, "there is no function " + quoted);
  auto known = b_.function_names();
  known.insert(known.end(), builtin_names().begin(), builtin_names().end());
  if (auto right = same_but_case(node.text, known); !right.empty())
    return error(node, source,
                 "there is no function " + quoted + ", did you mean '" + right +
                     "'? Small and capital letters differ",
                 right);
  const auto* mistake = find_mistake(MistakePlace::function, node.text, &known);
  if (mistake && !mistake->meant.empty())
    return error(node, source,
                 "there is no function " + quoted + "; it is called '" +
                     std::string(mistake->meant) + "'",
                 std::string(mistake->meant));
  error(node, source,
        "there is no function " + quoted +
            (mistake ? "; " + std::string(mistake->sentence)
                     : did_you_mean(node.text, known)));
}

} // namespace parlour::script
