// Texts and expressions, and the decision which of the two an attribute is
// (language rule 4).
#include <algorithm>
#include <cctype>

#include "runtime/base/value.hpp"
#include "script/compiler/code/expressions/expression_compiler.hpp"
#include "script/expression/builtins.hpp"
#include "script/expression/plain_brace.hpp"

namespace parlour::script {

namespace {

constexpr std::size_t shortest_mistake = 4;

std::string_view trimmed(std::string_view text) {
  constexpr auto blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool is_word_byte(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

// A single ASCII word, as the name of a variable would be.
bool is_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), is_word_byte) &&
         !std::isdigit(static_cast<unsigned char>(text[0]));
}

bool is_literal(const Node& node) {
  return node.kind == NodeKind::unknown || node.kind == NodeKind::boolean ||
         node.kind == NodeKind::string;
}

// A number that would print differently stays text (language rule 4.3): 007.
bool prints_as_written(const Node& node, std::string_view text) {
  if (node.kind == NodeKind::integer)
    return std::to_string(node.integer) == text;
  return number_text(node.number) == text;
}

} // namespace

NodePointer ExpressionCompiler::parse(const Source& source) {
  auto parsed = parse_expression(source.text);
  if (!parsed.node)
    report(source, parsed);
  return std::move(parsed.node);
}

void ExpressionCompiler::expression(const Source& source, Register target) {
  if (auto node = parse(source))
    into(*node, source, target);
}

bool ExpressionCompiler::is_declared(const std::string& name) const {
  return b_.find(name).kind != Meaning::Kind::nothing;
}

// Collects what the tree mentions.
void ExpressionCompiler::mentions(const Node& node, Mentions& found) const {
  if (is_this_field(node)) {
    found.declared = true;
    return;
  }
  found.quoted |= node.kind == NodeKind::string ||
                  (node.kind == NodeKind::map && node.flag);
  if (node.kind == NodeKind::call)
    found.called |= b_.function(node.text) || is_builtin(node.text);
  if (node.kind == NodeKind::name)
    (is_declared(node.text) ? found.declared : found.undeclared) = true;
  for (const auto& child : node.children)
    mentions(*child, found);
}

// A single literal is an expression. Everything else must be well-formed and
// contain a quoted text, a known function or a declared name (language rule
// 4.2), so that ordinary sentences with brackets or hyphens stay text.
NodePointer ExpressionCompiler::decide(const Source& source) {
  auto parsed = parse_expression(source.text);
  if (parsed.node) {
    const auto& node = *parsed.node;
    if (is_literal(node))
      return std::move(parsed.node);
    if (node.kind == NodeKind::integer || node.kind == NodeKind::number) {
      if (prints_as_written(node, trimmed(source.text)))
        return std::move(parsed.node);
      return nullptr;
    }
    // Everything else is an expression only if something in it is certainly
    // meant as one.
    Mentions found;
    mentions(node, found);
    if (found.quoted || found.called || found.declared)
      return std::move(parsed.node);
  }
  warn_of_text(source);
  return nullptr;
}

// Warns of a text that was probably meant as an expression: a single word that
// is nearly a variable (language rule 4.7), or words beside operators of which
// one is declared.
void ExpressionCompiler::warn_of_text(const Source& source) {
  const auto text = trimmed(source.text);
  if (is_word(text)) {
    const std::string word(text);
    const auto near = text.size() >= shortest_mistake
                          ? nearest(word, b_.visible_names())
                          : std::string();
    if (!near.empty())
      b_.findings.add({Severity::warning, source.spot(),
                       "'" + word +
                           "' is taken as text; for the variable write '" +
                           near + "'",
                       "text-like-expression"});
    return;
  }
  if (std::none_of(text.begin(), text.end(), [](char letter) {
        return letter == '+' || letter == '[' || letter == '(';
      }))
    return;
  if (source.text.find('{') != std::string_view::npos)
    return; // embedded expressions have checks of their own
  // Looks for a declared name beside '+', '[' or '('.
  for (std::size_t at = 0; at < source.text.size();) {
    auto end = at;
    while (end < source.text.size() && is_word_byte(source.text[end]))
      ++end;
    if (end == at) {
      ++at;
      continue;
    }
    const std::string word(source.text.substr(at, end - at));
    const auto before = trimmed(source.text.substr(0, at));
    const auto after = trimmed(source.text.substr(end));
    const bool opens = end < source.text.size() &&
                       (source.text[end] == '[' || source.text[end] == '(');
    if ((opens || before.ends_with('+') || after.starts_with('+')) &&
        is_declared(word)) {
      b_.findings.add({Severity::warning, source.spot(at, word.size()),
                       "this is taken as text, although '" + word +
                           "' is declared; it is not well-formed as an "
                           "expression, and a text embeds {" +
                           word + "}",
                       "text-like-expression"});
      return;
    }
    at = end;
  }
}

// Mistakes inside of a text that is no expression are not reported here: it may
// be meant as it is.
void ExpressionCompiler::text_or_expression(const Source& source,
                                            Register target) {
  auto either = source;
  either.wanted = Wanted::text;
  if (const auto node = decide(either))
    into(*node, either, target);
  else
    text(source, target);
}

// -- text with {expr} ---------------------------------------------------------

namespace {

// Neighbouring literal pieces are joined.
void add_literal(std::vector<TextPart>& parts, std::string_view text) {
  if (parts.empty() || parts.back().node)
    parts.emplace_back();
  parts.back().literal += text;
}

} // namespace

// Doubled braces become single ones; braces that embed nothing are literal.
// "Hello {name}!" becomes "Hello ", the tree of `name`, and "!".
std::vector<TextPart> ExpressionCompiler::split_text(const Source& source) {
  std::vector<TextPart> parts;
  const auto text = source.text;
  for (std::size_t at = 0; at < text.size();) {
    auto brace = at;
    while (brace < text.size() && text[brace] != '{' && text[brace] != '}')
      ++brace;
    if (brace > at)
      add_literal(parts, text.substr(at, brace - at));
    at = brace;
    if (at == text.size())
      break;
    const bool doubled = is_doubled(text, at);
    auto inside = doubled ? Embedded() : embedded(text, at);
    if (!inside.node) {
      add_literal(parts, text.substr(at, 1));
      at += doubled ? 2 : 1;
      continue;
    }
    parts.push_back(
        {{}, std::move(inside.node), source.part(at + 1, inside.end - at - 2)});
    at = inside.end;
  }
  return parts;
}

// A text without expressions is a constant; otherwise its parts are computed
// from left to right (language rule 4.5) and then joined.
void ExpressionCompiler::text(const Source& source, Register target) {
  const auto parts = split_text(source);
  if (parts.empty())
    return b_.load_text(target, "");
  if (parts.size() == 1 && !parts[0].node)
    return b_.load_text(target, parts[0].literal);
  const auto mark = b_.mark();
  const auto base = b_.allocate(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto reg = static_cast<Register>(base + i);
    if (parts[i].node)
      into(*parts[i].node, parts[i].source, reg);
    else
      b_.load_text(reg, parts[i].literal);
  }
  b_.emit(Operation::concatenate, target, base, parts.size());
  b_.release(mark);
}

} // namespace parlour::script
