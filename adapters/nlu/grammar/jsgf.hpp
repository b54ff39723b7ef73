// A parser for JSGF (the W3C Note) with this platform's references to values:
// text in, syntax tree out. The notation is described in
// adapters/nlu/README.md.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::adapters::nlu::jsgf {

enum class NodeKind : std::uint8_t {
  word,         // text
  rule,         // <text>
  reference,    // @text, <@text>: a value
  sequence,     // children
  alternatives, // children with weights
  optional,     // [child]
  star,         // child*
  plus,         // child+
  nothing,      // <NULL>
  never,        // <VOID>
};

// {name} or {name=value}. It belongs to the node that it follows.
struct Tag {
  std::string name;
  std::string value;
  bool has_value = false;
  SourceLocation place;
};

// A node of the syntax tree. `text` is the word or name; which other members
// are used depends on the kind.
struct Node {
  NodeKind kind = NodeKind::nothing;
  std::string text;
  std::vector<Node> children;
  // Of alternatives; each is above 0.
  std::vector<double> weights;
  std::vector<Tag> tags;
  SourceLocation place;
};

struct Rule {
  std::string name;
  bool is_public = false;
  Node body;
  SourceLocation place;
};

// A grammar and its rules, in the order of the text.
struct Grammar {
  std::string name;
  std::vector<Rule> rules;
};

// Parses a grammar. All errors are added to `errors`, with their place in the
// file in which the grammar stands. What could be read is returned in any case.
Grammar parse(const GrammarModel& model, std::vector<Error>& errors);

// The value of {Slot=value}: a boolean, a number or a text.
Value literal(const std::string& text);

} // namespace parlour::adapters::nlu::jsgf
