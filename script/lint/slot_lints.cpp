// unfillable-slot: nothing can fill a slot. joined-values: several values in
// one <value>.
//
//   <slot name="Time"/>                   no question, no values, no example
//   <value>tea, coffee</value>            one value with a comma
#include <algorithm>
#include <optional>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Whether an example of the topic marks the slot: "[David](Host)".
bool is_marked(const Element& topic, const std::string& slot) {
  const auto* examples = topic.child("examples");
  return examples &&
         std::any_of(examples->children.begin(), examples->children.end(),
                     [&](const Element& example) {
                       return example.text.find("](" + slot + ")") !=
                              std::string::npos;
                     });
}

// Tags of a grammar name slots in several ways, so finding the word is enough.
bool is_in_grammar(const LintContext& context, const std::string& slot) {
  const auto& model = context.program.understanding;
  return model &&
         std::any_of(model->grammars.begin(), model->grammars.end(),
                     [&](const GrammarModel& grammar) {
                       return grammar.text.find(slot) != std::string::npos;
                     });
}

// Whether a statement of the topic assigns the slot.
bool is_set(const Element& topic, const ElementRule& rule,
            const std::string& slot) {
  bool found = false;
  walk(topic, rule, [&](const Element& element, const ElementRule&) {
    const auto name = element.value(
        element.is("set") || element.is("append") ? "name" : "return");
    found |= name.starts_with("this." + slot);
  });
  return found;
}

// Whether a statement of the topic asks for the slot.
bool is_asked(const Element& topic, const ElementRule& rule,
              const std::string& slot) {
  bool found = false;
  walk(topic, rule, [&](const Element& element, const ElementRule&) {
    found |= element.is("ask") && (element.value("slot") == slot ||
                                   is_computed(element.value("slot")));
  });
  return found;
}

// A script that makes frames itself can fill any slot.
bool fires_frames(const LintContext& context) {
  bool found = false;
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    found |= is_statement(rule) && element.is("fire") &&
             element.value("param").find('{') != std::string::npos;
  });
  return found;
}

// A literal number.
std::optional<double> constant(const Element& element, const char* attribute) {
  const auto parsed = parse_expression(element.value(attribute));
  if (parsed.node && parsed.node->kind == NodeKind::integer)
    return static_cast<double>(parsed.node->integer);
  if (parsed.node && parsed.node->kind == NodeKind::number)
    return parsed.node->number;
  return {};
}

// A range with literal bounds that are in the wrong order.
void lint_range(const Element& slot, Findings& findings) {
  const auto* cardinality = slot.child("cardinality");
  if (!cardinality || cardinality->value("type") != "range")
    return;
  const auto from = constant(*cardinality, "from");
  const auto to = constant(*cardinality, "to");
  if (from && to && *from > *to)
    warn(findings, "unfillable-slot", cardinality->position,
         "no value is right for the slot '" + slot.value("name") +
             "': its range begins at " + cardinality->value("from") +
             " and ends at " + cardinality->value("to"));
}

// Explains "<value>a, b, c</value>".
void lint_values(const Element& slot, Findings& findings) {
  const auto* cardinality = slot.child("cardinality");
  if (!cardinality || cardinality->children.size() != 1)
    return;
  const auto& value = cardinality->children.front();
  if (value.text.find(',') != std::string::npos)
    warn(findings, "joined-values", value.position,
         "this is one value, with its commas; write a <value> for each");
}

// A slot can be filled by a question, a value set, an example, a grammar, a
// topic of its own or a script.
void lint_slot(const LintContext& context, const Element& topic,
               const ElementRule& rule, const Element& slot,
               Findings& findings) {
  lint_range(slot, findings);
  lint_values(slot, findings);
  const auto name = slot.value("name");
  const bool can_be_filled =
      slot.attribute("question") || slot.attribute("expr") ||
      slot.attribute("grammar") || slot.attribute("topic") ||
      slot.attribute("offer") || slot.child("cardinality") ||
      slot.child("help") || is_marked(topic, name) ||
      is_in_grammar(context, name) || is_set(topic, rule, name) ||
      is_asked(topic, rule, name);
  if (!can_be_filled)
    warn(findings, "unfillable-slot", slot.position,
         "nothing fills the slot '" + name +
             "'; give it a question=\"…\", a <cardinality>, or an example "
             "with [words](" +
             name + ")");
}

// An understanding component other than the platform's may find anything.
bool has_foreign_understanding(const LintContext& context) {
  const auto& known = context.options.component_roles;
  const auto& components = context.program.settings.components;
  return std::any_of(
      components.begin(), components.end(), [&](const auto& component) {
        const auto found = known.find(component.name);
        return found != known.end() && component.plugin != "GrammarNLU" &&
               std::find(found->second.begin(), found->second.end(), "NLU") !=
                   found->second.end();
      });
}

} // namespace

// Nothing is certain if frames or acts come from elsewhere.
void lint_slots(const LintContext& context, Findings& findings) {
  if (fires_frames(context) || has_foreign_understanding(context))
    return;
  walk(context, false, [&](const Element& topic, const ElementRule& rule) {
    if (!topic.is("topic") || std::find(rule.holds.begin(), rule.holds.end(),
                                        "topic") == rule.holds.end())
      return;
    for (const auto& slot : topic.children)
      if (slot.is("slot"))
        lint_slot(context, topic, rule, slot, findings);
  });
}

} // namespace parlour::script::lint
