// list-as-text and text-like-expression: a list or map where a text or a single
// value is meant, or the other way round.
//
//   <speak param="[name]"/>               said with its brackets
//   <for each="x" in="[list]">            one round only
//   <post … param="[1, 2]"/>              sent as a text (language rule 4.2)
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

bool is_collection(const Node& node) {
  return node.kind == NodeKind::list || node.kind == NodeKind::map;
}

// The name in "[count]", a list that probably was meant as a placeholder; else
// null.
const Node* only_name(const Node& node) {
  return node.kind == NodeKind::list && node.children.size() == 1 &&
                 node.children[0]->kind == NodeKind::name
             ? node.children[0].get()
             : nullptr;
}

// Whether the tree counts as an expression where text is possible, too
// (language rule 4.2).
bool is_expression(const Node& node, const std::set<std::string>& declared) {
  bool found = false;
  visit_below(node, [&](const Node& one) {
    found |= one.kind == NodeKind::call || one.kind == NodeKind::string ||
             (one.kind == NodeKind::name && declared.count(one.text) > 0) ||
             (one.kind == NodeKind::map && one.flag);
  });
  return found;
}

// Whether `param` of the element becomes the parameter of a message.
bool takes_params(const Element& element) {
  return element.is("post") || element.is("request") ||
         (element.is("fire") && element.attribute("event"));
}

// Whether somebody will hear or read the attribute.
bool is_said(const Element& element, const Attribute& attribute) {
  const auto& name = attribute.name;
  return (name == "param" &&
          (element.is("speak") || element.is("print") || element.is("log"))) ||
         name == "question" || name == "message";
}

// A list or map where words are expected.
void said(const Element& element, const Attribute& attribute, const Node& node,
          Findings& findings) {
  const auto source = source_of(attribute);
  if (const auto* name = only_name(node))
    return warn(findings, "list-as-text", source.spot(),
                "this is a list, and is given out as [ … ]; for the value "
                "write {" +
                    name->text + "}");
  if (element.is("print") || element.is("log"))
    return;
  warn(findings, "list-as-text", source.spot(),
       node.kind == NodeKind::list
           ? "this is a list, and is said as [ … ]; write list(" +
                 attribute.value + "), or a text with {…} for each value"
           : "this is a map, and is said as { … }; write a text with {…} for "
             "each value");
}

// A map or list that is text because nothing in it is declared or quoted.
void handed_over(const Attribute& attribute, const Node& node,
                 Findings& findings) {
  warn(findings, "text-like-expression", source_of(attribute).spot(),
       std::string("this is handed over as a text; for a ") +
           (node.kind == NodeKind::list ? "list" : "map") +
           " write <param expr=\"" + attribute.value + "\"/> inside");
}

// A <for each> over a list that consists of one name only.
void gone_through(const Attribute& attribute, const Node& node,
                  Findings& findings) {
  if (const auto* name = only_name(node))
    warn(findings, "list-as-text", source_of(attribute).spot(),
         "this is a list of one element; to go through '" + name->text +
             "' write in=\"" + name->text + "\"");
}

} // namespace

// Whether the value counts as an expression decides which mistake it is.
void lint_lists(const LintContext& context, Findings& findings) {
  const auto declared = declared_names(context);
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    for (const auto& attribute : element.attributes) {
      const auto parsed = parse_expression(attribute.value);
      if (!rule.attribute(attribute.name) || !parsed.node ||
          !is_collection(*parsed.node))
        continue;
      const bool computes = is_expression(*parsed.node, declared);
      if (computes && is_said(element, attribute))
        said(element, attribute, *parsed.node, findings);
      else if (element.is("for") && attribute.name == "in")
        gone_through(attribute, *parsed.node, findings);
      else if (!computes && attribute.name == "param" && takes_params(element))
        handed_over(attribute, *parsed.node, findings);
    }
  });
}

} // namespace parlour::script::lint
