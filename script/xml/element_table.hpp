// ElementTable: what elements.def says, as data. Immutable; any thread.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "script/source/by_name.hpp"

namespace parlour::script {

// clang-format off
#define PARLOUR_ATTRIBUTE_KINDS(X) \
  X(name, "a name: a letter or _, then letters, digits or _") \
  X(expression, "an expression") \
  X(text_or_expression, "text or an expression (language rule 4)") \
  X(text, "text with {expr}") \
  X(literal, "text as it is") \
  X(duration, "a duration such as 200ms, 1.5s or 2m") \
  X(boolean, "true or false") \
  X(choice, "one of a few words") \
  X(integer, "a whole number, 0 or more") \
  X(size, "a size such as 500, 64KB or 16MB") \
  X(state, "a state's name") \
  X(topic, "a topic's name") \
  X(slot, "a slot's name") \
  X(function, "a function's name") \
  X(handler, "a handler's name") \
  X(grammar, "a grammar's name") \
  X(module, "a role or a component") \
  X(command, "a command of the component") \
  X(column, "a column's name")
// clang-format on

enum class AttributeKind : std::uint8_t {
#define X(name, sentence) name,
  PARLOUR_ATTRIBUTE_KINDS(X)
#undef X
};

std::string_view sentence_of(AttributeKind kind);

struct AttributeRule {
  std::string name;
  AttributeKind kind = AttributeKind::literal;
  bool required = false;
  std::vector<std::string> words; // of a choice
  std::string sentence;
};

// One attribute of a form: what it may say where only some words of it belong
// to the form, and whether it may be missing.
struct FormWord {
  std::string attribute;
  std::vector<std::string> values; // empty: any
  bool required = true;
};

// Attributes that make one way of writing an element.
using AttributeForm = std::vector<FormWord>;

// Null where the form has no such attribute.
const FormWord* find_word(const AttributeForm& form,
                          std::string_view attribute);

// An attribute and children of that name ("text": character data) that say the
// same.
struct Either {
  std::string attribute;
  std::string child;
};

struct ElementRule {
  std::string name; // "*": every name without a rule of its own
  std::vector<std::string> in;
  std::vector<std::string> holds;
  bool available = true;
  std::string sentence;
  std::vector<AttributeRule> attributes;
  std::vector<AttributeForm> forms = {}; // empty: any of its attributes
  std::vector<std::string> once = {};    // children
  std::vector<std::string> last = {};    // children, behind all others
  bool in_parts = false;                 // which those begin
  std::vector<Either> either = {};
  // The rules of what may stand inside; known in element_table() only.
  ByName<const ElementRule*> inside = {};

  // The rule of an element in here; null where it may not stand here.
  const ElementRule* child(std::string_view child_name) const;
  // Null where there is none; "*" rules stand for all names.
  const AttributeRule* attribute(std::string_view attribute_name) const;
  bool holds_text() const;
  // Whether its forms are about that attribute.
  bool is_in_a_form(std::string_view attribute_name) const;
  // Whether such a child may stand in it once only.
  bool holds_once(std::string_view child_name) const;
  // Its place among those that stand behind all others, from 1 on; 0: none.
  std::size_t last_place(std::string_view child_name) const;
  std::vector<std::string> attribute_names() const;
};

const std::vector<ElementRule>& element_table();

// The rule of an element among contents `within` (the parent's `holds`; "root"
// for a document's element); null where it may not stand there.
const ElementRule* find_rule(std::string_view name,
                             const std::vector<std::string>& within);

// The names that may stand within these contents.
std::vector<std::string> names_within(const std::vector<std::string>& within);

// The names of the elements that may hold an element of that name; empty where
// the name is in no row.
std::vector<std::string> parents_of(std::string_view name);

// Whether there are elements of that name, the first letter's case aside.
bool is_element_name(std::string_view name);

// "a", "a or b", "a, b or c".
std::string alternatives(const std::vector<std::string>& words);

} // namespace parlour::script
