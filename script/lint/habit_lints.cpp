// always-true, unreachable-statement, lost-transit, case-without-effect: habits
// from other languages that mean something else here.
//
//   <if cond="find(text, 'a')">           also true for -1
//   <return/><print param="never"/>       unreachable
//   <case value="1, 2">                   one value only
//   <transit state="A"/><transit state="B"/>   only the last counts
#include <algorithm>
#include <array>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// -- conditions ---------------------------------------------------------------

// find() and indexof() return -1 if there is no match, which counts as true.
std::string always_true_in(const Node& node) {
  if (node.kind == NodeKind::call &&
      (node.text == "find" || node.text == "indexof"))
    return "'" + node.text +
           "' gives the place, from 0 on, and -1 where there is none, which "
           "counts as true; write contains(…), or compare: " +
           node.text + "(…) ge 0";
  const bool joins =
      node.kind == NodeKind::both || node.kind == NodeKind::either;
  if (joins || node.kind == NodeKind::invert)
    for (const auto& child : node.children)
      if (auto fault = always_true_in(*child); !fault.empty())
        return fault;
  return {};
}

void lint_condition(const Attribute& attribute, Findings& findings) {
  const auto parsed = parse_expression(attribute.value);
  if (!parsed.node)
    return;
  if (auto fault = always_true_in(*parsed.node); !fault.empty())
    warn(findings, "always-true", attribute.value_position, std::move(fault));
}

// -- what comes behind --------------------------------------------------------

// Statements behind which the block does not continue.
bool leaves_its_block(const Element& element) {
  static constexpr std::array<const char*, 4> names{"return", "break",
                                                    "continue", "throw"};
  return std::ranges::any_of(
      names, [&](const char* name) { return element.is(name); });
}

// The statements of one block. Parts such as <else> and <catch> are no
// statements.
void lint_block(const Element& block, const ElementRule& rule,
                Findings& findings) {
  const Element* left = nullptr;
  const Element* transit = nullptr;
  for (const auto& child : block.children) {
    const auto* inside = find_rule(child.name, rule.holds);
    if (!inside || !is_statement(*inside))
      continue;
    if (left)
      return warn(findings, "unreachable-statement", child.position,
                  "nothing leads here: <" + left->name + "> in line " +
                      std::to_string(left->position.line) +
                      " leaves before; put <" + child.name +
                      "> in front of it, or take it out");
    if (transit && child.is("transit"))
      warn(findings, "lost-transit", transit->position,
           "of several <transit> the last counts, that of line " +
               std::to_string(child.position.line) + "; take this one out");
    if (leaves_its_block(child))
      left = &child;
    if (child.is("transit"))
      transit = &child;
  }
}

// -- <case> -------------------------------------------------------------------

bool is_literal(const Node& node) {
  return node.kind == NodeKind::string || node.kind == NodeKind::integer ||
         node.kind == NodeKind::number;
}

// Whether the value is written as if it were several: "'a' or 'b'" or "1, 2".
bool is_several(const std::string& value) {
  const auto whole = parse_expression(value);
  if (whole.node)
    return whole.node->kind == NodeKind::either &&
           std::ranges::all_of(whole.node->children, [](const auto& child) {
             return is_literal(*child);
           });
  const auto list = parse_arguments(value);
  return list.node && list.node->children.size() > 1 &&
         std::ranges::all_of(list.node->children, [](const auto& child) {
           return is_literal(*child);
         });
}

// A <case> takes one value and does not run on into the next (language rule
// 6.2).
void lint_switch(const Element& element, Findings& findings) {
  const auto& arms = element.children;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const auto* value = arms[i].attribute("value");
    if (value && is_several(value->value))
      warn(findings, "case-without-effect", value->value_position,
           "a <case> is for one value; write one for each");
    if (value && arms[i].children.empty() && i + 1 < arms.size() &&
        arms[i + 1].is("case"))
      warn(findings, "case-without-effect", arms[i].position,
           "for this value nothing happens: an empty <case> does not run on "
           "into the next; put the same statements into both, or a function");
  }
}

} // namespace

void lint_habits(const LintContext& context, Findings& findings) {
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    for (const auto* name : {"cond", "if"})
      if (const auto* condition = element.attribute(name))
        lint_condition(*condition, findings);
    lint_block(element, rule, findings);
    if (is_statement(rule) && element.is("switch"))
      lint_switch(element, findings);
  });
}

} // namespace parlour::script::lint
