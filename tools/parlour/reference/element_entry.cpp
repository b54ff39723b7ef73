// Makes entries from the element table. "Content" below is a name for a group
// of elements that may stand together, such as "statements"; an element is part
// of contents (`in`) and holds contents (`holds`).
#include "tools/parlour/reference/element_entry.hpp"

#include <algorithm>

#include "tools/parlour/reference/examples.hpp"

namespace parlour::tools {

namespace {

using script::AttributeForm;
using script::ElementRule;
using Words = std::vector<std::string>;

constexpr const char* statements = "statements";

Words tags_of(const Words& elements) {
  Words tags;
  for (const auto& element : elements)
    tags.push_back(tag_of(element));
  return tags;
}

bool has(const Words& words, const std::string& word) {
  return std::ranges::count(words, word) > 0;
}

// The elements that may contain this content, each once.
Words elements_that_hold(const std::string& content) {
  Words names;
  for (const auto& rule : script::element_table())
    if (has(rule.holds, content) && !has(names, rule.name))
      names.push_back(rule.name);
  return names;
}

// Adds the places where a content stands: "a file of its own", "statements", or
// the tags of the elements that hold it.
void add_places(Words& places, const std::string& content) {
  if (content == "root")
    places.emplace_back("a file of its own");
  else if (content == statements)
    places.emplace_back(statements);
  else
    for (const auto& tag : tags_of(elements_that_hold(content)))
      if (!has(places, tag))
        places.push_back(tag);
}

// All places where an element may stand.
Words places_of(const ElementRule& rule) {
  Words places;
  for (const auto& content : rule.in)
    add_places(places, content);
  return places;
}

// What an element may contain: "text", "statements" or tags.
std::string contents_of(const ElementRule& rule) {
  Words contents;
  for (const auto& content : rule.holds)
    if (content == "text" || content == statements)
      contents.push_back(content);
    else
      std::ranges::copy(tags_of(script::names_within({content})),
                        std::back_inserter(contents));
  return listed(contents);
}

// A form as text: "cond", "name from=1|2 step?".
std::string text_of(const AttributeForm& form) {
  Words words;
  for (const auto& word : form)
    words.push_back(
        word.attribute +
        (word.values.empty() ? "" : "=" + listed(word.values, "|")) +
        (word.required ? "" : "?"));
  return listed(words, " ");
}

// The alternative sets of attributes of an element.
std::string forms_of(const ElementRule& rule) {
  Words forms;
  for (const auto& form : rule.forms)
    forms.push_back(text_of(form));
  return listed(forms, "; ");
}

// Facts without text are left out.
void add_fact(Entry& entry, const char* label, const std::string& text) {
  if (!text.empty())
    entry.facts.push_back({label, text});
}

// Things that are given as an attribute or as content, but not both.
void add_either(Entry& entry, const ElementRule& rule) {
  for (const auto& either : rule.either)
    add_fact(entry, "either",
             either.attribute + ", or " +
                 (either.child == "text" ? "text" : tag_of(either.child)) +
                 " inside");
}

void add_facts(Entry& entry, const ElementRule& rule) {
  if (!rule.available)
    add_fact(entry, "not yet", "it is refused so far");
  add_fact(entry, "stands in", listed(places_of(rule)));
  add_fact(entry, "holds", contents_of(rule));
  add_fact(entry, "once each", listed(tags_of(rule.once)));
  add_fact(entry, "at the end", listed(tags_of(rule.last)));
  add_fact(entry, "written with", forms_of(rule));
  add_either(entry, rule);
}

Entry entry_of(const ElementRule& rule) {
  Entry entry{rule.name, title_of(rule), rule.sentence};
  // Rows such as "*" have no sentence of their own.
  if (entry.sentence.empty())
    entry.sentence = "whatever one likes";
  add_facts(entry, rule);
  for (const auto& attribute : rule.attributes)
    entry.details.push_back({attribute.name == "*" ? "NAME" : attribute.name,
                             kind_of(attribute), attribute.sentence});
  if (const auto* example = example_of(rule)) {
    add_fact(entry, "told in", example->told);
    entry.example = example->xml;
  }
  return entry;
}

} // namespace

std::string tag_of(const std::string& element) {
  return element == "*" ? "<NAME>" : "<" + element + ">";
}

std::string title_of(const ElementRule& rule) {
  if (example_name(rule) == rule.name)
    return tag_of(rule.name);
  // The first place tells elements of one name apart.
  const auto places = places_of(rule);
  return tag_of(rule.name) +
         (places.front() == statements ? " among " : " in ") + places.front() +
         (places.size() > 2 ? " and others" : "");
}

std::string kind_of(const script::AttributeRule& attribute) {
  const auto words = attribute.words.size() > 1
                         ? script::alternatives(attribute.words)
                         : listed(attribute.words);
  return (attribute.required ? "needed; " : "") +
         (words.empty() ? std::string(script::sentence_of(attribute.kind))
                        : words);
}

std::vector<Entry> element_entries() {
  std::vector<Entry> entries;
  for (const auto& rule : script::element_table())
    entries.push_back(entry_of(rule));
  return entries;
}

Entry statements_entry() {
  Entry entry{statements, statements, "what runs, one after the other"};
  add_fact(entry, "stand in", listed(tags_of(elements_that_hold(statements))));
  add_fact(entry, "these are",
           listed(tags_of(script::names_within({statements}))));
  return entry;
}

} // namespace parlour::tools
