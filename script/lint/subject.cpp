#include "script/lint/subject.hpp"

#include <algorithm>

#include "script/expression_compiler.hpp"

namespace parlour::script::lint {

namespace {

bool contains(const std::vector<std::string>& words, const char* word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

void visit_whole(std::string_view text,
                 const std::function<void(const Node&)>& visit) {
  if (const auto parsed = parse_expression(text); parsed.node)
    visit(*parsed.node);
}

void visit_embedded(std::string_view text,
                    const std::function<void(const Node&)>& visit) {
  if (text.find('{') == std::string_view::npos)
    return;
  for (const auto& part : ExpressionCompiler::split_text({text, {}}))
    if (part.node)
      visit(*part.node);
}

// What `<set name="list[i].key">` reads: all but a plain name.
void visit_target(std::string_view text,
                  const std::function<void(const Node&)>& visit) {
  const auto parsed = parse_expression(text);
  if (parsed.node && parsed.node->kind != NodeKind::name)
    visit(*parsed.node);
}

void visit_attribute(const Attribute& attribute, const ElementRule& element,
                     const AttributeRule& rule,
                     const std::function<void(const Node&)>& visit) {
  using enum AttributeKind;
  const std::string_view value = attribute.value;
  if (rule.name == "args") {
    if (const auto parsed = parse_arguments(value); parsed.node)
      visit(*parsed.node);
  } else if (rule.kind == expression) {
    visit_whole(value, visit);
  } else if (rule.kind == text_or_expression) {
    visit_whole(value, visit);
    visit_embedded(value, visit);
  } else if ((rule.name == "name" || rule.name == "return") &&
             is_statement(element) && rule.kind == literal) {
    visit_target(value, visit);
  } else {
    visit_embedded(value, visit);
  }
}

} // namespace

bool is_statement(const ElementRule& rule) {
  return contains(rule.in, "statements");
}

bool is_computed(std::string_view text) {
  return text.find('{') != std::string_view::npos;
}

void walk(const Element& element, const ElementRule& rule, const Visit& visit) {
  visit(element, rule);
  for (const auto& child : element.children)
    if (const auto* inside = find_rule(child.name, rule.holds))
      walk(child, *inside, visit);
}

const ElementRule& rule_of(const Element& root) {
  static const ElementRule none;
  const auto* rule = find_rule(root.name, {"root"});
  return rule ? *rule : none;
}

void walk(const Subject& subject, bool platform, const Visit& visit) {
  for (const auto& document : subject.documents)
    if (platform || !document.platform)
      walk(document.root, rule_of(document.root), visit);
  if (subject.settings)
    walk(*subject.settings, rule_of(*subject.settings), visit);
}

void visit_expressions(const Element& element, const ElementRule& rule,
                       const std::function<void(const Node&)>& visit) {
  for (const auto& attribute : element.attributes)
    if (const auto* known = rule.attribute(attribute.name))
      visit_attribute(attribute, rule, *known, visit);
  if (rule.holds_text())
    visit_embedded(element.text, visit);
}

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

void warn(Findings& findings, const char* lint, Position position,
          std::string message) {
  findings.add({Severity::warning, {position}, std::move(message), lint});
}

} // namespace parlour::script::lint
