// Reads elements.def into rules at the first use and links each rule to the
// rules of its possible children.

#include "script/xml/element_table.hpp"

#include <algorithm>

#include "runtime/text/words.hpp"

namespace parlour::script {

namespace {

constexpr std::string_view any_name = "*";

// Reads a word of a form: "name", "name?" or "name=word|word".
FormWord form_word(std::string text) {
  FormWord word;
  if (text.ends_with('?')) {
    word.required = false;
    text.pop_back();
  }
  const auto values = std::min(text.find('='), text.size());
  word.attribute = text.substr(0, values);
  std::replace(text.begin(), text.end(), '|', ' ');
  if (values < text.size())
    word.values = split_words(text.c_str() + values + 1);
  return word;
}

AttributeForm form_of(const char* text) {
  AttributeForm form;
  for (auto& word : split_words(text))
    form.push_back(form_word(std::move(word)));
  return form;
}

// The macros of the table append to the element that was added last.
std::vector<ElementRule> read_table() {
  std::vector<ElementRule> all;
  enum { later, ready };
  enum { optional, required };
#define ELEMENT(name, in, holds, availability, sentence)                       \
  all.push_back({name,                                                         \
                 split_words(in),                                              \
                 split_words(holds),                                           \
                 availability == ready,                                        \
                 sentence,                                                     \
                 {}});
#define ATTRIBUTE(name, kind, need, words, sentence)                           \
  all.back().attributes.push_back({name, AttributeKind::kind,                  \
                                   need == required, split_words(words),       \
                                   sentence});
#define FORM(words) all.back().forms.push_back(form_of(words));
#define EITHER(attribute, child)                                               \
  all.back().either.push_back({attribute, child});
#define ONCE(names) all.back().once = split_words(names);
#define LAST(names) all.back().last = split_words(names);
#define PARTS(names)                                                           \
  all.back().last = split_words(names);                                        \
  all.back().in_parts = true;
#include "script/xml/elements.def"
#undef ELEMENT
#undef ATTRIBUTE
#undef FORM
#undef EITHER
#undef ONCE
#undef LAST
#undef PARTS
  return all;
}

// Whether the lists have a word in common: a parent's `holds` and a child's
// `in`.
bool overlap(const std::vector<std::string>& a,
             const std::vector<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const auto& one) {
    return std::find(b.begin(), b.end(), one) != b.end();
  });
}

// Adds a name unless it is there already or stands for any.
void add_once(std::vector<std::string>& names, const std::string& name) {
  if (name != any_name &&
      std::find(names.begin(), names.end(), name) == names.end())
    names.push_back(name);
}

} // namespace

std::string_view sentence_of(AttributeKind kind) {
  static constexpr const char* sentences[] = {
#define X(name, sentence) sentence,
      PARLOUR_ATTRIBUTE_KINDS(X)
#undef X
  };
  return sentences[static_cast<std::size_t>(kind)];
}

const AttributeRule*
ElementRule::attribute(std::string_view attribute_name) const {
  for (const auto& rule : attributes)
    if (rule.name == attribute_name || rule.name == any_name)
      return &rule;
  return nullptr;
}

bool ElementRule::holds_text() const {
  return std::find(holds.begin(), holds.end(), "text") != holds.end();
}

namespace {

auto find_name(const std::vector<std::string>& names, std::string_view name) {
  return std::find_if(names.begin(), names.end(),
                      [&](const auto& one) { return same_name(one, name); });
}

} // namespace

const FormWord* find_word(const AttributeForm& form,
                          std::string_view attribute) {
  for (const auto& word : form)
    if (word.attribute == attribute)
      return &word;
  return nullptr;
}

bool ElementRule::is_in_a_form(std::string_view attribute_name) const {
  return std::any_of(forms.begin(), forms.end(), [&](const auto& form) {
    return find_word(form, attribute_name);
  });
}

bool ElementRule::holds_once(std::string_view child_name) const {
  return find_name(once, child_name) != once.end();
}

// Positions count from 1, so that 0 can stand for all other children.
std::size_t ElementRule::last_place(std::string_view child_name) const {
  const auto found = find_name(last, child_name);
  return found == last.end()
             ? 0
             : static_cast<std::size_t>(found - last.begin()) + 1;
}

std::vector<std::string> ElementRule::attribute_names() const {
  std::vector<std::string> names;
  for (const auto& rule : attributes)
    add_once(names, rule.name);
  return names;
}

// Links parents to the rules of their children once, so that validating a
// document needs one hash lookup for each element.
const std::vector<ElementRule>& element_table() {
  static const std::vector<ElementRule> table = [] {
    auto all = read_table();
    for (auto& parent : all)
      for (const auto& rule : all)
        if (overlap(rule.in, parent.holds))
          parent.inside.emplace(rule.name, &rule);
    return all;
  }();
  return table;
}

// A rule "*" takes every name that no other rule of the parent has.
const ElementRule* ElementRule::child(std::string_view child_name) const {
  auto found = inside.find(child_name);
  if (found == inside.end())
    found = inside.find(any_name);
  return found == inside.end() ? nullptr : found->second;
}

// A rule with the name is preferred to a rule for any name.
const ElementRule* find_rule(std::string_view name,
                             const std::vector<std::string>& within) {
  const ElementRule* any = nullptr;
  for (const auto& rule : element_table()) {
    if (!overlap(rule.in, within))
      continue;
    if (same_name(rule.name, name))
      return &rule;
    if (rule.name == any_name)
      any = &rule;
  }
  return any;
}

std::vector<std::string> names_within(const std::vector<std::string>& within) {
  std::vector<std::string> names;
  for (const auto& rule : element_table())
    if (overlap(rule.in, within))
      add_once(names, rule.name);
  return names;
}

// Searches the whole table: used for messages only.
std::vector<std::string> parents_of(std::string_view name) {
  std::vector<std::string> parents;
  for (const auto& rule : element_table()) {
    if (!same_name(rule.name, name))
      continue;
    for (const auto& parent : element_table())
      if (overlap(rule.in, parent.holds))
        add_once(parents, parent.name);
  }
  return parents;
}

bool is_element_name(std::string_view name) {
  return std::any_of(
      element_table().begin(), element_table().end(),
      [name](const auto& rule) { return same_name(rule.name, name); });
}

// As a sentence lists choices.
std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0)
      text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

} // namespace parlour::script
