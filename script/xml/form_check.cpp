// An example: <for> has the forms "name from to step?" and "each in index?".
//
//   <for name="i" from="1" to="3">     the first form
//   <for each="x" in="list">           the second form
//   <for each="x" from="1" to="3">     'from' contradicts 'each'
//   <for each="x">                     'in' is missing

#include "script/xml/form_check.hpp"

#include <algorithm>
#include <utility>

namespace parlour::script {

namespace {

// The forms that are still possible, as pointers into the table.
using Forms = std::vector<const AttributeForm*>;
using Given = std::vector<const Attribute*>;

// Whether the form has the attribute with this value.
bool allows(const AttributeForm& form, const Attribute& attribute) {
  const auto* word = find_word(form, attribute.name);
  return word && (word->values.empty() ||
                  std::ranges::count(word->values, attribute.value) != 0);
}

// The forms that remain possible once the attribute is given.
Forms that_allow(const Attribute& attribute, const Forms& forms) {
  Forms allowing;
  for (const auto* form : forms)
    if (allows(*form, attribute))
      allowing.push_back(form);
  return allowing;
}

Forms forms_of(const ElementRule& rule) {
  Forms forms;
  for (const auto& form : rule.forms)
    forms.push_back(&form);
  return forms;
}

AttributeKind kind_of(const Attribute& attribute, const ElementRule& rule) {
  const auto* known = rule.attribute(attribute.name);
  return known ? known->kind : AttributeKind::literal;
}

// Whether the forms differ by the words of this attribute, as <cardinality
// type>.
bool chooses_the_form(const Attribute& attribute, const ElementRule& rule) {
  const auto* word = find_word(rule.forms.front(), attribute.name);
  return word && !word->values.empty();
}

// The attributes that any form mentions; first the one whose words choose the
// form, as errors are best explained by it.
Given given(const Element& element, const ElementRule& rule) {
  Given all;
  for (const auto& attribute : element.attributes) {
    const bool is_off = attribute.value == "false" &&
                        kind_of(attribute, rule) == AttributeKind::boolean;
    if (!is_off && rule.is_in_a_form(attribute.name))
      all.push_back(&attribute);
  }
  std::stable_partition(all.begin(), all.end(), [&](const Attribute* one) {
    return chooses_the_form(*one, rule);
  });
  return all;
}

// -- words --------------------------------------------------------------------

// "'each'", or "drop=\"true\"" for a boolean.
std::string shown(const Attribute& attribute, const ElementRule& rule) {
  return kind_of(attribute, rule) == AttributeKind::boolean
             ? attribute.name + "=\"" + attribute.value + "\""
             : "'" + attribute.name + "'";
}

std::string shown(const AttributeForm& form) {
  std::string text;
  for (const auto& word : form)
    text += (text.empty() ? "" : ", ") + word.attribute;
  return text;
}

// "write either name, from, to, step, or each, in, index".
std::string ways_of(const ElementRule& rule) {
  std::string text;
  for (const auto& form : rule.forms)
    text += (text.empty() ? "write either " : ", or ") + shown(form);
  return text;
}

// "that belongs to type=\"range\"", where `chooser` is the attribute `type`.
std::string place_of(const Attribute& attribute, const std::string& chooser,
                     const ElementRule& rule) {
  for (const auto& form : rule.forms)
    if (find_word(form, attribute.name))
      return "that belongs to " + chooser + "=\"" +
             find_word(form, chooser)->values.front() + "\"";
  return {};
}

// -- what excludes each other -------------------------------------------------

// Whether some form allows both. Each alone is in some form.
bool go_together(const Attribute& one, const Attribute& other,
                 const ElementRule& rule) {
  return std::ranges::any_of(rule.forms, [&](const auto& form) {
    return allows(form, one) && allows(form, other);
  });
}

// The message: by the word that chose the form, if there is one, else by both
// attributes and the possible ways.
std::string conflict(const Attribute& attribute, const Attribute& before,
                     const ElementRule& rule) {
  const auto tag = "<" + rule.name;
  if (chooses_the_form(before, rule))
    return tag + " " + before.name + "=\"" + before.value + "\"> has no " +
           shown(attribute, rule) + "; " +
           place_of(attribute, before.name, rule);
  return tag + "> has both " + shown(before, rule) + " and " +
         shown(attribute, rule) + "; " + ways_of(rule);
}

void report(const Attribute& attribute, std::string message,
            Findings& findings) {
  findings.add({Severity::error,
                {.start = attribute.position,
                 .length = attribute.name.size(),
                 .raw = true},
                std::move(message),
                "attribute"});
}

void erase(Element& element, const std::vector<std::string>& names) {
  std::erase_if(element.attributes, [&](const Attribute& attribute) {
    return std::ranges::count(names, attribute.name) != 0;
  });
}

// Narrows the possible forms attribute by attribute. An attribute that leaves
// no form contradicts the ones before; only the first such attribute is
// reported, and all are removed.
bool check_excluding(Element& element, const ElementRule& rule,
                     Findings& findings) {
  auto forms = forms_of(rule);
  Given fitting;
  std::vector<std::string> wrong;
  for (const auto* attribute : given(element, rule)) {
    // The attribute fits at least one form that fits all before it.
    if (auto left = that_allow(*attribute, forms); !left.empty()) {
      forms = std::move(left);
      fitting.push_back(attribute);
      continue;
    }
    // The earlier attribute with which it never goes together.
    const auto before =
        std::ranges::find_if(fitting, [&](const Attribute* other) {
          return !go_together(*attribute, *other, rule);
        });
    if (wrong.empty())
      report(*attribute,
             conflict(*attribute,
                      before == fitting.end() ? *fitting.front() : **before,
                      rule),
             findings);
    wrong.push_back(attribute->name);
  }
  erase(element, wrong);
  return wrong.empty();
}

// -- what says the same -------------------------------------------------------

bool has(const Element& element, const std::string& child) {
  return child == "text" ? !collapsed(element.text).empty()
                         : element.child(child) != nullptr;
}

// Removes an attribute that says the same as a child (EITHER); the child stays.
void check_doubled(Element& element, const ElementRule& rule,
                   Findings& findings) {
  for (const auto& either : rule.either) {
    const auto* attribute = element.attribute(either.attribute);
    if (!attribute || !has(element, either.child))
      continue;
    const auto other =
        either.child == "text" ? "a text" : "<" + either.child + ">";
    report(*attribute,
           "<" + rule.name + "> has both '" + either.attribute + "' and " +
               other + " inside of it; leave one out",
           findings);
    erase(element, {either.attribute});
  }
}

// -- what is missing ----------------------------------------------------------

// The first required attribute of a form that is not given.
const FormWord* missing_word(const AttributeForm& form, const Given& given) {
  for (const auto& word : form)
    if (word.required &&
        std::ranges::none_of(given, [&](const Attribute* attribute) {
          return attribute->name == word.attribute;
        }))
      return &word;
  return nullptr;
}

} // namespace

bool check_forms(Element& element, const ElementRule& rule,
                 Findings& findings) {
  check_doubled(element, rule, findings);
  return rule.forms.empty() || check_excluding(element, rule, findings);
}

// Every form that fits the given attributes lacks at least one; these are the
// choices. If one form lacks nothing, the element is complete.
std::vector<const AttributeRule*> missing_of_form(const Element& element,
                                                  const ElementRule& rule) {
  if (rule.forms.empty())
    return {};
  const auto there = given(element, rule);
  auto forms = forms_of(rule);
  for (const auto* attribute : there)
    forms = that_allow(*attribute, forms);
  std::vector<const AttributeRule*> missing;
  for (const auto* form : forms) {
    const auto* word = missing_word(*form, there);
    if (!word)
      return {};
    const auto* attribute = rule.attribute(word->attribute);
    if (std::ranges::count(missing, attribute) == 0)
      missing.push_back(attribute);
  }
  return missing;
}

} // namespace parlour::script
