#include "script/xml/validator.hpp"

#include <algorithm>
#include <utility>

#include "script/expression/common_mistakes.hpp"
#include "script/expression/expression_mistakes.hpp"
#include "script/xml/attribute_check.hpp"
#include "script/xml/content_check.hpp"
#include "script/xml/form_check.hpp"
#include "script/xml/tag_rename.hpp"

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

// The table's spelling; of the rule "*" the written name.
const std::string& name_of(const Element& element, const ElementRule& rule) {
  return rule.name == "*" ? element.name : rule.name;
}

// ", did you mean …", or the list of possible names if it is short.
std::string hint(const std::string& name,
                 const std::vector<std::string>& candidates,
                 const std::string& otherwise) {
  auto near = did_you_mean(name, candidates);
  if (!near.empty() || candidates.empty() || candidates.size() > 16)
    return near;
  return otherwise + alternatives(candidates);
}

bool holds(const ElementRule& rule, const char* what) {
  return std::find(rule.holds.begin(), rule.holds.end(), what) !=
         rule.holds.end();
}

// A statement with children of its own kind, such as <switch>.
bool holds_its_own(const ElementRule& rule) {
  return std::find(rule.in.begin(), rule.in.end(), "statements") !=
             rule.in.end() &&
         !holds(rule, "statements");
}

// Whether words of other programming languages may be meant. In the settings
// they are more likely to be misspellings.
bool is_of_script(const ElementRule& rule) {
  return holds(rule, "statements") || rule.name == "dialogue";
}

// The attribute that a text in the element was meant for; null if none.
const char* attribute_of_text(const ElementRule& rule) {
  for (const auto* name : {"param", "expr"})
    if (rule.attribute(name) && !holds(rule, "statements"))
      return name;
  return nullptr;
}

// Advice for text in an element that holds none.
std::string instead_of_text(const ElementRule& rule, const std::string& text) {
  const auto* name = attribute_of_text(rule);
  if (!name && holds(rule, "statements"))
    return "to say it, write <speak param=\"" + text + "\"/>";
  if (!name)
    return "expected elements only";
  const auto parsed = parse_expression(text);
  const bool computes = parsed.node && parsed.node->kind != NodeKind::name;
  return "write it as an attribute: " + std::string(name) + "=\"" +
         (*name == 'e' && !computes ? quoted_text(text) : text) + "\"";
}

class Validator {
public:
  explicit Validator(Findings& findings) : findings_(findings) {}

  bool validate_root(Element& root, const std::vector<std::string>& roots);

private:
  // Checks an element with all that is in it. Returns false if the parent must
  // remove it. `inside` is the parent's name for messages.
  bool validate(Element& element, const ElementRule& parent,
                const std::string& inside);
  void validate_inside(Element& element, const ElementRule& rule);
  void add(const Element& element, std::string message, const char* name);
  void rename(const Element& element, const std::string& name);
  std::string report_misplaced(const Element& element,
                               const ElementRule& parent,
                               const std::string& inside);
  std::string report_unknown(const Element& element, const ElementRule& parent,
                             const std::string& inside);
  std::string report_unknown(const Attribute& attribute, const Element& element,
                             const ElementRule& rule);
  void check_text(const Element& element, const ElementRule& rule);
  // Returns the names of the attributes that were removed for their values;
  // they are not missing.
  std::vector<std::string> check_attributes(Element& element,
                                            const ElementRule& rule);
  // One of `missing` is needed. Silent if one of them is in `told`.
  void report_missing(const Element& element, const ElementRule& rule,
                      const std::vector<const AttributeRule*>& missing,
                      const std::vector<std::string>& told);
  bool fill_missing(Element& element, const ElementRule& rule,
                    const std::vector<std::string>& told);
  bool fill_form(Element& element, const ElementRule& rule,
                 const std::vector<std::string>& told);

  Findings& findings_;
};

void Validator::add(const Element& element, std::string message,
                    const char* name) {
  findings_.add(
      {Severity::error, {element.position}, std::move(message), name});
}

// Adds a correction that renames the element. Only for names that are certain.
void Validator::rename(const Element& element, const std::string& name) {
  constexpr std::size_t max_findings = 100; // each searches for its end tag
  if (findings_.all().size() > max_findings)
    return;
  const auto& source = findings_.text(element.position.file);
  for (auto& edit :
       rename_tags(source.text(), source.offset_of(element.position), name))
    findings_.add_edit(std::move(edit));
}

// Reports a known element at a place where it may not stand. Returns the name
// of the element that was meant; empty if that is unknown.
std::string Validator::report_misplaced(const Element& element,
                                        const ElementRule& parent,
                                        const std::string& inside) {
  auto text = tag(element.name) + " may not stand in " + tag(inside) + "; ";
  const auto parents = parents_of(element.name);
  const auto allowed = names_within(parent.holds);
  const auto* mistake =
      is_of_script(parent)
          ? find_mistake(MistakePlace::element, element.name, &allowed)
          : nullptr;
  if (mistake && mistake->meant.empty())
    text += mistake->sentence;
  else if (mistake)
    text += "here it is called " + tag(std::string(mistake->meant)) +
            (mistake->sentence.empty() ? "" : " ") +
            std::string(mistake->sentence);
  else if (holds_its_own(parent) && !allowed.empty())
    text += "expected " + tags(allowed);
  else if (parents.size() > 6)
    text += "it is a statement: put it into a <function>, a state's "
            "<Entrance>, an event or the like";
  else
    text += "it belongs in " + tags(parents);
  add(element, text, "element");
  return mistake ? std::string(mistake->meant) : std::string();
}

// Reports an element that the language does not have. Returns the name that was
// meant, as which it is checked on; empty if that is unknown. Tries another
// case, then the words of other languages, then similar names.
std::string Validator::report_unknown(const Element& element,
                                      const ElementRule& parent,
                                      const std::string& inside) {
  if (!explains(findings_)) {
    add(element, "unknown element " + tag(element.name), "element");
    return {};
  }
  const auto allowed = names_within(parent.holds);
  auto text = "unknown element " + tag(element.name) + " in " + tag(inside);
  auto right = same_but_case(element.name, allowed);
  const auto* mistake = right.empty() ? find_mistake(MistakePlace::element,
                                                     element.name, &allowed)
                                      : nullptr;
  bool sure = !right.empty();
  if (sure) {
    text +=
        ", did you mean " + tag(right) + "? Small and capital letters differ";
  } else if (mistake && !mistake->meant.empty()) {
    right = mistake->meant;
    sure = mistake->sentence.empty();
    text += "; here it is called " + tag(right) + (sure ? "" : " ") +
            std::string(mistake->sentence);
  } else if (mistake) {
    text += "; " + std::string(mistake->sentence);
  } else {
    right = nearest(element.name, allowed);
    text += allowed.empty() ? "; it holds no elements"
                            : hint(element.name, allowed, "; expected ");
  }
  add(element, text, "element");
  if (sure)
    rename(element, right);
  return right;
}

void Validator::check_text(const Element& element, const ElementRule& rule) {
  if (element.text.empty() || rule.holds_text())
    return;
  auto text = collapsed(element.text);
  if (text.empty())
    return;
  if (text.size() > 40)
    text = text.substr(0, text.find(' ', 20)) + " …";
  findings_.add({Severity::error,
                 {.start = element.text_position, .length = text.size()},
                 "text '" + text + "' may not stand in " + tag(rule.name) +
                     "; " + instead_of_text(rule, text),
                 "text"});
}

std::string Validator::report_unknown(const Attribute& attribute,
                                      const Element& element,
                                      const ElementRule& rule) {
  const auto names = rule.attribute_names();
  auto text = tag(name_of(element, rule)) + " has no attribute '" +
              attribute.name + "'";
  auto right = same_but_case(attribute.name, names);
  bool sure = !right.empty();
  if (sure) {
    text += ", did you mean '" + right + "'? Small and capital letters differ";
  } else if (const auto* mistake = find_mistake(MistakePlace::attribute,
                                                attribute.name, &names)) {
    right = mistake->meant;
    sure = mistake->sentence.empty();
    text += "; here it is called '" + right + "'" + (sure ? "" : ", and ") +
            std::string(mistake->sentence);
  } else {
    right = nearest(attribute.name, names);
    text += hint(attribute.name, names, "; it has ");
  }
  findings_.add({Severity::error,
                 {.start = attribute.position,
                  .length = attribute.name.size(),
                  .raw = true},
                 text,
                 "attribute",
                 sure && !element.attribute(right) ? std::optional(right)
                                                   : std::nullopt});
  return right;
}

// An unknown attribute whose right name is certain or likely is renamed and
// then checked like any other, so one misspelling causes one finding.
std::vector<std::string> Validator::check_attributes(Element& element,
                                                     const ElementRule& rule) {
  std::vector<std::string> told;
  std::erase_if(element.attributes, [&](Attribute& attribute) {
    const auto* found = rule.attribute(attribute.name);
    if (!found) {
      auto right = report_unknown(attribute, element, rule);
      found = right.empty() || element.attribute(right) ? nullptr
                                                        : rule.attribute(right);
      if (!found)
        return true;
      attribute.name = std::move(right);
    }
    auto wrong = wrong_value(rule, *found, attribute.value);
    if (wrong.empty())
      return false;
    told.push_back(attribute.name);
    const auto right = same_but_case(attribute.value, found->words);
    findings_.add({Severity::error,
                   {attribute.value_position},
                   std::move(wrong),
                   "value",
                   right.empty() ? std::nullopt : std::optional(right)});
    return true;
  });
  return told;
}

namespace {

// Adds `unknown` for a missing expression. False for other kinds.
bool fill(Element& element, const AttributeRule& attribute) {
  using enum AttributeKind;
  if (attribute.kind != expression && attribute.kind != text_or_expression)
    return false;
  element.attributes.push_back(
      {attribute.name, "unknown", element.position, element.position});
  return true;
}

} // namespace

void Validator::report_missing(const Element& element, const ElementRule& rule,
                               const std::vector<const AttributeRule*>& missing,
                               const std::vector<std::string>& told) {
  std::vector<std::string> names;
  for (const auto* attribute : missing) {
    if (std::find(told.begin(), told.end(), attribute->name) != told.end())
      return;
    names.push_back("'" + attribute->name + "'");
  }
  add(element,
      tag(rule.name) + " needs the attribute " + alternatives(names) +
          (missing.size() == 1 ? ": " + missing.front()->sentence : ""),
      "attribute");
}

// Returns false if the element is useless without what is missing.
bool Validator::fill_missing(Element& element, const ElementRule& rule,
                             const std::vector<std::string>& told) {
  bool usable = true;
  for (const auto& attribute : rule.attributes) {
    if (!attribute.required || element.attribute(attribute.name))
      continue;
    report_missing(element, rule, {&attribute}, told);
    usable &= fill(element, attribute);
  }
  return usable && fill_form(element, rule, told);
}

// Completes a form, as long as there is no choice between attributes.
bool Validator::fill_form(Element& element, const ElementRule& rule,
                          const std::vector<std::string>& told) {
  for (auto missing = missing_of_form(element, rule); !missing.empty();
       missing = missing_of_form(element, rule)) {
    report_missing(element, rule, missing, told);
    if (missing.size() > 1 || !fill(element, *missing.front()))
      return false;
  }
  return true;
}

void Validator::validate_inside(Element& element, const ElementRule& rule) {
  check_text(element, rule);
  gather_parts(element, rule, findings_);
  const auto& inside = name_of(element, rule);
  std::erase_if(element.children,
                [&](Element& child) { return !validate(child, rule, inside); });
  check_children(element, rule, findings_);
}

// The order matters: the name first, as everything else depends on the rule;
// then the values; then the forms, of which missing attributes are a
// consequence. `told` collects attributes about which something was said
// already, so that they are not reported as missing as well.
bool Validator::validate(Element& element, const ElementRule& parent,
                         const std::string& inside) {
  const auto* rule = parent.inside.empty()
                         ? find_rule(element.name, parent.holds)
                         : parent.child(element.name);
  if (!rule) {
    const bool is_known = !parents_of(element.name).empty();
    const auto meant = is_known ? report_misplaced(element, parent, inside)
                                : report_unknown(element, parent, inside);
    rule = meant.empty() ? nullptr : find_rule(meant, parent.holds);
    if (!rule)
      return false;
    element.name = meant;
  }
  if (!rule->available) {
    findings_.error(element.position,
                    tag(rule->name) + " is not available yet");
    return false;
  }
  auto told = check_attributes(element, *rule);
  if (!element.text.empty())
    if (const auto* meant = attribute_of_text(*rule))
      told.push_back(meant); // given as text
  if (!check_forms(element, *rule, findings_))
    for (const auto& attribute : rule->attributes)
      told.push_back(attribute.name);
  const bool usable = fill_missing(element, *rule, told);
  validate_inside(element, *rule);
  return usable;
}

bool Validator::validate_root(Element& root,
                              const std::vector<std::string>& roots) {
  const auto matches = [&](const std::string& name) {
    return same_name(name, root.name);
  };
  if (std::none_of(roots.begin(), roots.end(), matches)) {
    findings_.error(root.position, "the root element is " + tag(root.name) +
                                       "; expected " + tags(roots));
    return false;
  }
  static const ElementRule document{"", {}, {"root"}, true, "", {}};
  return validate(root, document, "");
}

} // namespace

bool validate(Element& root, const std::vector<std::string>& roots,
              Findings& findings) {
  return Validator(findings).validate_root(root, roots);
}

} // namespace parlour::script
