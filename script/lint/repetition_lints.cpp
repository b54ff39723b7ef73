// repeated: something stands a second time where only the first counts.
// empty-text: something would be said without words.
//
//   <cardinality type="set"><value>tea</value><value>tea</value>
//   <speak param=""/>
#include <map>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Reports an element that repeats an earlier one.
void warn_of_second(const Element& element, const Element& first,
                    const std::string& what, Findings& findings) {
  warn(findings, "repeated", element.position,
       what + " stands in line " + std::to_string(first.position.line) +
           " already; take this one out");
}

// The values of a set.
void lint_set(const Element& cardinality, Findings& findings) {
  std::map<std::string, const Element*> seen;
  for (const auto& value : cardinality.children)
    if (value.is("value") && !value.attribute("expr"))
      if (const auto [first, is_new] =
              seen.emplace(collapsed(value.text), &value);
          !is_new)
        warn_of_second(value, *first->second,
                       "the value '" + first->first + "'", findings);
}

// Repairs with equal keys have the same act and the same conditions, so only
// the first is ever used.
std::string key_of(const Element& repair) {
  std::string key;
  for (const auto* name : {"act", "topic", "slot", "count", "if"})
    key += repair.value(name) + '\n';
  return key;
}

// An attribute that is to be spoken, and is empty.
void lint_silence(const Element& element, const char* attribute,
                  Findings& findings) {
  const auto* words = element.attribute(attribute);
  if (words && collapsed(words->value).empty())
    warn(findings, "empty-text", words->position,
         "nothing is said by an empty " + words->name + "; write the words");
}

} // namespace

// Repairs are compared over all files, as the first of all of them counts.
void lint_repetitions(const LintContext& context, Findings& findings) {
  std::map<std::string, const Element*> repairs;
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    if (element.is("cardinality") && element.value("type") == "set")
      lint_set(element, findings);
    if (is_statement(rule) && element.is("speak"))
      lint_silence(element, "param", findings);
    if (is_statement(rule) && element.is("confirm"))
      lint_silence(element, "question", findings);
    if (is_statement(rule) || !element.is("repair"))
      return;
    const auto [first, is_new] = repairs.emplace(key_of(element), &element);
    if (!is_new)
      warn_of_second(element, *first->second,
                     "a <repair> of this act with the same conditions",
                     findings);
  });
}

} // namespace parlour::script::lint
