// The element table: what elements.def says, as data. Immutable and safe from
// any thread.
//
// How contents connect parents and children: <state> has holds="state", and
// <Entrance> has in="state", so <Entrance> may stand in <state>. <if> has
// in="statements" and holds="if statements": it is a statement itself and holds
// statements and its own parts.
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

// What a value of this kind is, as messages say it.
std::string_view sentence_of(AttributeKind kind);

struct AttributeRule {
  std::string name;
  AttributeKind kind = AttributeKind::literal;
  bool required = false;
  std::vector<std::string> words; // of a choice
  std::string sentence;
};

// One attribute of a form. If only some of its words belong to the form,
// `values` lists these.
struct FormWord {
  std::string attribute;
  std::vector<std::string> values; // empty: any
  bool required = true;
};

// The attributes that together make one way of writing an element.
using AttributeForm = std::vector<FormWord>;

// Returns null if the form has no such attribute.
const FormWord* find_word(const AttributeForm& form,
                          std::string_view attribute);

// An attribute that says the same as children of that name; "text" stands for
// character data.
struct Either {
  std::string attribute;
  std::string child;
};

// All rules about one element at one place. The same name may have several
// rules for different parents, such as <var> as a declaration and as an
// argument.
struct ElementRule {
  std::string name; // "*": every name without a rule of its own
  // `in` lists the kinds of contents that the element may be part of and
  // `holds` those that its children are part of. A parent takes a child if one
  // of the parent's `holds` is in the child's `in`.
  std::vector<std::string> in;
  std::vector<std::string> holds;
  bool available = true;
  std::string sentence;
  std::vector<AttributeRule> attributes;
  std::vector<AttributeForm> forms = {}; // empty: any of its attributes
  std::vector<std::string> once = {};    // children
  std::vector<std::string> last = {};    // children, behind all others
  bool in_parts = false;                 // which `last` begin
  // Attributes and children of which only one may be given.
  std::vector<Either> either = {};
  // The rules of all possible children by name, made when the table is read.
  ByName<const ElementRule*> inside = {};

  // The rule for a child of that name; null if it may not stand here.
  const ElementRule* child(std::string_view child_name) const;
  // The rule for an attribute; null if there is none. A rule "*" covers all
  // names.
  const AttributeRule* attribute(std::string_view attribute_name) const;
  // Whether character data may stand in it.
  bool holds_text() const;
  // Whether one of the forms mentions the attribute.
  bool is_in_a_form(std::string_view attribute_name) const;
  // Whether a child of that name may occur only once.
  bool holds_once(std::string_view child_name) const;
  // The position of the child among those that must be last, from 1; 0 for
  // others.
  std::size_t last_place(std::string_view child_name) const;
  std::vector<std::string> attribute_names() const;
};

// Read at first use; lives as long as the process.
const std::vector<ElementRule>& element_table();

// The rule of an element whose parent holds `within` ("root" for a document's
// root); null if it may not stand there. Takes time linear in the table;
// ElementRule::child is faster.
const ElementRule* find_rule(std::string_view name,
                             const std::vector<std::string>& within);

// The names of all elements that these contents may have.
std::vector<std::string> names_within(const std::vector<std::string>& within);

// The names of all elements that may contain an element of that name; empty if
// no row has the name.
std::vector<std::string> parents_of(std::string_view name);

// Whether any row has this name (language rule 1.4).
bool is_element_name(std::string_view name);

// "a", "a or b", "a, b or c".
std::string alternatives(const std::vector<std::string>& words);

} // namespace parlour::script
