#include "script/validator.hpp"

#include <algorithm>

#include "script/attribute_check.hpp"

namespace parlour::script {

namespace {

std::string tag(const std::string& name) {
  return "<" + name + ">";
}

// "<a>, <b> or <c>".
std::string tags(std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  for (auto& name : names)
    name = tag(name);
  return alternatives(names);
}

// An element without a row of its own is called what it is called.
const std::string& name_of(const Element& element, const ElementRule& rule) {
  return rule.name == "*" ? element.name : rule.name;
}

// ", did you mean …" or what there is to choose from.
std::string hint(const std::string& name,
                 const std::vector<std::string>& candidates,
                 const std::string& otherwise) {
  auto near = did_you_mean(name, candidates);
  if (!near.empty() || candidates.empty() || candidates.size() > 12)
    return near;
  return otherwise + alternatives(candidates);
}

class Validator {
public:
  explicit Validator(Findings& findings) : findings_(findings) {}

  bool validate_root(Element& root, const std::vector<std::string>& roots);

private:
  // False where the element must be taken out. `inside` names its parent.
  bool validate(Element& element, const ElementRule& parent,
                const std::string& inside);
  bool validate(Element& element, const ElementRule& rule);
  void validate_inside(Element& element, const ElementRule& rule);
  void report_unknown(const Element& element, const ElementRule& parent,
                      const std::string& inside);
  bool replace_unavailable(Element& element, const ElementRule& rule);
  void check_text(const Element& element, const ElementRule& rule);
  void check_attributes(Element& element, const ElementRule& rule);
  void report_missing(const Element& element, const ElementRule& rule);
  bool fill_missing(Element& element, const ElementRule& rule);

  Findings& findings_;
};

void Validator::report_unknown(const Element& element,
                               const ElementRule& parent,
                               const std::string& inside) {
  const auto parents = parents_of(element.name);
  const auto allowed = names_within(parent.holds);
  std::string text;
  if (!parents.empty()) {
    text = tag(element.name) + " may not stand in " + tag(inside) + "; ";
    text += parents.size() > 6 ? "it is a statement"
                               : "it belongs in " + tags(parents);
  } else {
    text = "unknown element " + tag(element.name) + " in " + tag(inside);
    text += allowed.empty() ? "; it holds no elements"
                            : hint(element.name, allowed, "; expected ");
  }
  findings_.error(element.position, text);
}

// Where it would have set a variable, the variable is declared, so that its
// uses are no further findings.
bool Validator::replace_unavailable(Element& element, const ElementRule& rule) {
  findings_.error(element.position, tag(rule.name) + " is not available yet");
  const auto* variable = element.attribute("return");
  if (!variable || !is_identifier(variable->value))
    return false;
  auto name = *variable;
  name.name = "name";
  element.name = "var";
  element.attributes = {name};
  element.children.clear();
  return true;
}

void Validator::check_text(const Element& element, const ElementRule& rule) {
  if (element.text.empty() || rule.holds_text())
    return;
  auto text = collapsed(element.text);
  if (text.empty())
    return;
  if (text.size() > 40)
    text = text.substr(0, text.find(' ', 20)) + " …";
  findings_.error(element.text_position,
                  "text '" + text + "' may not stand in " + tag(rule.name) +
                      "; expected elements only");
}

void Validator::check_attributes(Element& element, const ElementRule& rule) {
  std::erase_if(element.attributes, [&](const Attribute& attribute) {
    const auto* found = rule.attribute(attribute.name);
    if (!found) {
      auto text = tag(name_of(element, rule)) + " has no attribute '" +
                  attribute.name + "'";
      findings_.error(
          attribute.position,
          text + hint(attribute.name, rule.attribute_names(), "; it has "));
      return true;
    }
    auto wrong = wrong_value(rule, *found, attribute.value);
    if (wrong.empty())
      return false;
    findings_.error(attribute.value_position, std::move(wrong));
    return true;
  });
}

void Validator::report_missing(const Element& element,
                               const ElementRule& rule) {
  for (const auto& attribute : rule.attributes)
    if (attribute.required && !element.attribute(attribute.name))
      findings_.error(element.position,
                      tag(rule.name) + " needs the attribute '" +
                          attribute.name + "': " + attribute.sentence);
}

bool Validator::fill_missing(Element& element, const ElementRule& rule) {
  using enum AttributeKind;
  bool usable = true;
  for (const auto& attribute : rule.attributes) {
    if (!attribute.required || element.attribute(attribute.name))
      continue;
    const bool mendable =
        attribute.kind == expression || attribute.kind == text_or_expression;
    usable = usable && mendable;
    if (mendable)
      element.attributes.push_back(
          {attribute.name, "unknown", element.position, element.position});
  }
  return usable;
}

void Validator::validate_inside(Element& element, const ElementRule& rule) {
  check_text(element, rule);
  const auto& inside = name_of(element, rule);
  std::erase_if(element.children,
                [&](Element& child) { return !validate(child, rule, inside); });
}

bool Validator::validate(Element& element, const ElementRule& parent,
                         const std::string& inside) {
  const auto* rule = parent.child(element.name);
  if (rule)
    return validate(element, *rule);
  report_unknown(element, parent, inside);
  return false;
}

bool Validator::validate(Element& element, const ElementRule& rule) {
  if (!rule.available)
    return replace_unavailable(element, rule);
  report_missing(element, rule);
  check_attributes(element, rule);
  const bool usable = fill_missing(element, rule);
  validate_inside(element, rule);
  return usable;
}

bool Validator::validate_root(Element& root,
                              const std::vector<std::string>& roots) {
  const auto matches = [&](const std::string& name) {
    return same_name(name, root.name);
  };
  const auto* rule = find_rule(root.name, {"root"});
  if (rule && std::any_of(roots.begin(), roots.end(), matches))
    return validate(root, *rule);
  findings_.error(root.position, "the root element is " + tag(root.name) +
                                     "; expected " + tags(roots));
  return false;
}

} // namespace

bool validate(Element& root, const std::vector<std::string>& roots,
              Findings& findings) {
  return Validator(findings).validate_root(root, roots);
}

} // namespace parlour::script
