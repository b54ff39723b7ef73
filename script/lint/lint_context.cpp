// Walking through an application: elements with their rules, and the
// expressions in their attributes and texts.

#include "script/lint/lint_context.hpp"

#include <algorithm>

#include "script/compiler/code/expressions/expression_compiler.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script::lint {

namespace {

bool contains(const std::vector<std::string>& words, const char* word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// The expression that a whole value is; nothing if it is not well-formed.
void visit_whole(const Source& source, const VisitNode& visit) {
  if (const auto parsed = parse_expression(source.text); parsed.node)
    visit(*parsed.node, source);
}

// The expressions in the braces of a text.
void visit_embedded(const Source& source, const VisitNode& visit) {
  if (source.text.find('{') == std::string_view::npos)
    return;
  for (const auto& part : ExpressionCompiler::split_text(source))
    if (part.node)
      visit(*part.node, part.source);
}

// What the target of `<set name="list[i].key">` reads; a plain name reads
// nothing.
void visit_target(const Source& source, const VisitNode& visit) {
  const auto parsed = parse_expression(source.text);
  if (parsed.node && parsed.node->kind != NodeKind::name)
    visit(*parsed.node, source);
}

// How an attribute is read depends on its kind in the element table.
void visit_attribute(const Attribute& attribute, const ElementRule& element,
                     const AttributeRule& rule, const VisitNode& visit) {
  using enum AttributeKind;
  const auto source = source_of(attribute);
  if (rule.name == "args") {
    if (const auto parsed = parse_arguments(source.text); parsed.node)
      visit(*parsed.node, source);
  } else if (rule.kind == expression) {
    visit_whole(source, visit);
  } else if (rule.kind == text_or_expression) {
    visit_whole(source, visit);
    visit_embedded(source, visit);
  } else if ((rule.name == "name" || rule.name == "return") &&
             is_statement(element) && rule.kind == literal) {
    visit_target(source, visit);
  } else {
    visit_embedded(source, visit);
  }
}

} // namespace

bool is_statement(const ElementRule& rule) {
  return contains(rule.in, "statements");
}

bool is_computed(std::string_view text) {
  return text.find('{') != std::string_view::npos;
}

// Elements without a rule were reported by the validator and are skipped.
void walk(const Element& element, const ElementRule& rule, const Visit& visit) {
  visit(element, rule);
  for (const auto& child : element.children)
    if (const auto* inside = find_rule(child.name, rule.holds))
      walk(child, *inside, visit);
}

// An empty rule stands in for an unknown root, so that walking finds nothing.
const ElementRule& rule_of(const Element& root) {
  static const ElementRule none;
  const auto* rule = find_rule(root.name, {"root"});
  return rule ? *rule : none;
}

void walk(const LintContext& context, bool platform, const Visit& visit) {
  for (const auto& document : context.documents)
    if (platform || !document.platform)
      walk(document.root, rule_of(document.root), visit);
  if (context.settings)
    walk(*context.settings, rule_of(*context.settings), visit);
}

void walk_statements(const LintContext& context, bool platform,
                     const std::function<void(const Element&)>& visit) {
  walk(context, platform, [&](const Element& element, const ElementRule& rule) {
    if (is_statement(rule))
      visit(element);
  });
}

// Text of an element is collapsed first, as the compiler does.
void visit_nodes(const Element& element, const ElementRule& rule,
                 const VisitNode& visit) {
  for (const auto& attribute : element.attributes)
    if (const auto* known = rule.attribute(attribute.name))
      visit_attribute(attribute, rule, *known, visit);
  if (!rule.holds_text())
    return;
  const auto text = collapsed(element.text);
  visit_embedded({text, element.text_position, true}, visit);
}

void visit_expressions(const Element& element, const ElementRule& rule,
                       const std::function<void(const Node&)>& visit) {
  visit_nodes(element, rule,
              [&](const Node& node, const Source&) { visit(node); });
}

void visit_below(const Node& node,
                 const std::function<void(const Node&)>& visit) {
  visit(node);
  for (const auto& child : node.children)
    visit_below(*child, visit);
}

// `this` itself counts as a name, which does no harm.
void mentions_of(const Node& node, Mentions& mentions) {
  if (node.kind == NodeKind::name)
    mentions.names.insert(node.text);
  else if (node.kind == NodeKind::call)
    mentions.calls.insert(node.text);
  else if (is_this_field(node))
    mentions.slots.insert(node.text);
  for (const auto& child : node.children)
    mentions_of(*child, mentions);
}

void mentions_of(const Element& element, const ElementRule& rule,
                 Mentions& mentions) {
  visit_expressions(element, rule,
                    [&](const Node& node) { mentions_of(node, mentions); });
  if (element.is("call"))
    mentions.calls.insert(element.value("function"));
}

Mentions all_mentions(const Element& element, const ElementRule& rule) {
  Mentions mentions;
  walk(element, rule, [&](const Element& one, const ElementRule& its) {
    mentions_of(one, its, mentions);
  });
  return mentions;
}

// All elements that declare variables do it by one of these attributes.
std::set<std::string> declared_names(const LintContext& context) {
  std::set<std::string> names{"this"};
  walk(context, true, [&](const Element& element, const ElementRule&) {
    for (const auto* attribute : {"name", "return", "each", "index"})
      if (const auto value = element.value(attribute); is_identifier(value))
        if (element.is("var") || element.is("const") || element.is("param") ||
            element.is("object") || element.is("getlist") ||
            element.is("for") || element.is("catch") ||
            std::string_view(attribute) == "return")
          names.insert(value);
  });
  return names;
}

void warn(Findings& findings, const char* lint, Position position,
          std::string message) {
  warn(findings, lint, Spot{position}, std::move(message));
}

void warn(Findings& findings, const char* lint, const Spot& spot,
          std::string message) {
  findings.add({Severity::warning, spot, std::move(message), lint});
}

} // namespace parlour::script::lint
