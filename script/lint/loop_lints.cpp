// endless-loop and empty-loop: a loop that cannot end or never runs.
//
//   <while cond="i lt 3"> without <set name="i">      never ends
//   <for name="i" from="3" to="1">                    never runs
#include <algorithm>
#include <array>
#include <optional>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Statements that may end a loop, or that let time pass so that something else
// can end it.
bool may_end(const Element& element) {
  static constexpr std::array<const char*, 11> names{
      "break", "return",  "throw",   "end",     "transit", "wait",
      "pop",   "confirm", "request", "querydb", "complete"};
  return std::any_of(names.begin(), names.end(),
                     [&](const char* name) { return element.is(name); });
}

// What the statements of a loop may change.
struct Changes {
  std::set<std::string> names;
  bool anything = false; // it calls a function
  bool ends = false;
};

// The variable of a target: "list" of "list[2].key".
std::string root_name(std::string_view target) {
  const auto parsed = parse_expression(target);
  const auto* node = parsed.node.get();
  while (node &&
         (node->kind == NodeKind::index || node->kind == NodeKind::field))
    node = node->children[0].get();
  return node && node->kind == NodeKind::name ? node->text : std::string();
}

// The condition itself is left out: only the body can change it.
Changes changes_of(const LintContext& context, const Element& loop,
                   const ElementRule& rule) {
  Changes changes;
  Mentions mentions;
  walk(loop, rule, [&](const Element& element, const ElementRule& its) {
    if (&element == &loop)
      return;
    mentions_of(element, its, mentions);
    if (!is_statement(its))
      return;
    changes.ends |= may_end(element);
    for (const auto* attribute : {"name", "return"})
      changes.names.insert(root_name(element.value(attribute)));
    if (element.is("call"))
      for (const auto& argument : element.children)
        changes.names.insert(root_name(argument.value("expr")));
  });
  for (const auto& call : mentions.calls)
    changes.anything |= context.program.functions.count(call) > 0;
  // Built-in functions that change their argument.
  for (const auto* name : {"append", "insert", "remove", "sort", "reverse"})
    changes.anything |= mentions.calls.count(name) > 0;
  return changes;
}

// The truth of a literal condition.
std::optional<bool> certain_truth(const Node& node) {
  switch (node.kind) {
  case NodeKind::boolean:
    return node.flag;
  case NodeKind::integer:
    return node.integer != 0;
  case NodeKind::string:
    return !node.text.empty();
  case NodeKind::unknown:
    return false;
  default:
    return {};
  }
}

bool reads_what_may_change(const Mentions& condition, const Changes& changes) {
  const auto& names = condition.names;
  const bool changed =
      std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return changes.names.count(name) > 0 || name.starts_with('_');
      });
  // A function may read anything, and a slot can be filled from outside.
  return changed || !condition.calls.empty() || !condition.slots.empty();
}

// Warns only if nothing in the loop can change its condition or leave it.
void lint_while(const LintContext& context, const Element& loop,
                const ElementRule& rule, Findings& findings) {
  const auto* condition = loop.attribute("cond");
  const auto parsed =
      parse_expression(condition ? condition->value : std::string());
  const auto changes = changes_of(context, loop, rule);
  if (!parsed.node || changes.ends)
    return;
  const auto truth = certain_truth(*parsed.node);
  if (truth && !*truth)
    return warn(findings, "empty-loop", condition->value_position,
                "this loop never runs: its condition is always false");
  Mentions mentions;
  mentions_of(*parsed.node, mentions);
  if (truth)
    return warn(findings, "endless-loop", condition->value_position,
                "this loop cannot end: its condition is always true, and "
                "nothing in it is a <break> or <return>");
  if (changes.anything || reads_what_may_change(mentions, changes))
    return;
  warn(findings, "endless-loop", condition->value_position,
       "this loop cannot end once it runs: nothing in it changes '" +
           (mentions.names.empty() ? condition->value
                                   : *mentions.names.begin()) +
           "'; <set> it, or leave by <break>");
}

// A literal bound; the default of `step` is 1.
std::optional<double> bound(const Element& loop, const char* attribute) {
  const auto* given = loop.attribute(attribute);
  if (!given)
    return std::string_view(attribute) == "step" ? std::optional(1.0)
                                                 : std::nullopt;
  const auto parsed = parse_expression(given->value);
  if (!parsed.node)
    return {};
  if (parsed.node->kind == NodeKind::integer)
    return static_cast<double>(parsed.node->integer);
  return parsed.node->kind == NodeKind::number
             ? std::optional(parsed.node->number)
             : std::nullopt;
}

// A counting loop whose literal bounds and step lead nowhere (language rule
// 6.3).
void lint_for(const Element& loop, Findings& findings) {
  const auto from = bound(loop, "from"), to = bound(loop, "to"),
             step = bound(loop, "step");
  if (!from || !to || !step)
    return;
  const bool never = *step == 0 || (*step > 0 ? *from > *to : *from < *to);
  if (never)
    warn(findings, "empty-loop", loop.position,
         "this loop never runs: from " + loop.value("from") + " no step of " +
             (loop.attribute("step") ? loop.value("step") : "1") +
             " leads to " + loop.value("to") +
             (loop.attribute("step") ? ""
                                     : "; counting down needs "
                                       "step=\"-1\""));
}

} // namespace

// A <for each> always ends, as it walks over a copy.
void lint_loops(const LintContext& context, Findings& findings) {
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    if (!is_statement(rule))
      return;
    if (element.is("while"))
      lint_while(context, element, rule, findings);
    else if (element.is("for") && !element.attribute("each"))
      lint_for(element, findings);
  });
}

} // namespace parlour::script::lint
