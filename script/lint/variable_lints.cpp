// unread-variable: nothing reads a variable.
//
//   <var name="total" expr="a + b"/>      and `total` occurs nowhere else
//
// Names that are only assigned count as not read.
#include "script/lint/passes.hpp"
#include "script/xml/attribute_check.hpp"

namespace parlour::script::lint {

namespace {

// The variable that a statement declares, if it is a plain name.
const Attribute* written(const Element& element) {
  const Attribute* attribute = nullptr;
  if (element.is("var") || element.is("const") || element.is("object") ||
      element.is("getlist"))
    attribute = element.attribute("name");
  return attribute && is_identifier(attribute->value) ? attribute : nullptr;
}

void report(const Element& element, const Attribute& name, Findings& findings) {
  warn(findings, "unread-variable", name.value_position,
       "nothing reads the variable '" + name.value +
           "'; use it, or take the <" + element.name + "> out");
}

// Local variables: everything that happens to them happens in the same body.
void lint_locals(const Element& owner, const ElementRule& rule,
                 const std::set<std::string>& session, Findings& findings) {
  auto read = all_mentions(owner, rule).names;
  // A variable that takes a statement's result may be there only for that.
  walk(owner, rule, [&](const Element& element, const ElementRule&) {
    read.insert(element.value("return"));
  });
  std::set<std::string> told = session;
  walk(owner, rule, [&](const Element& element, const ElementRule& its) {
    const auto* name = is_statement(its) ? written(element) : nullptr;
    if (name && !read.count(name->value) && told.insert(name->value).second)
      report(element, *name, findings);
  });
}

// The names that any expression of the application mentions.
std::set<std::string> read_anywhere(const LintContext& context) {
  Mentions mentions;
  walk(context, true, [&](const Element& element, const ElementRule& rule) {
    mentions_of(element, rule, mentions);
  });
  return mentions.names;
}

} // namespace

// Session variables are judged by the whole application, locals by their body.
void lint_variables(const LintContext& context, Findings& findings) {
  std::set<std::string> session;
  for (const auto& variable : context.program.variables)
    session.insert(variable.name);
  const auto read = read_anywhere(context);
  for (const auto& document : context.documents) {
    const auto& rule = rule_of(document.root);
    for (const auto& child : document.root.children) {
      const auto* inside = find_rule(child.name, rule.holds);
      if (document.platform || !inside)
        continue;
      if (!child.is("var") && !child.is("const"))
        lint_locals(child, *inside, session, findings);
      else if (const auto* name = written(child);
               name && context.is_whole() && !read.count(name->value))
        report(child, *name, findings);
    }
  }
}

} // namespace parlour::script::lint
