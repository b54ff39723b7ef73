// JSGF (the W3C Note) with this platform's references to values: text in,
// syntax tree out. The notation is described in this folder's README.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/understanding.hpp"

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

// {name}, {name=value}: belongs to the node it follows.
struct Tag {
  std::string name;
  std::string value;
  bool has_value = false;
  Place place;
};

struct Node {
  NodeKind kind = NodeKind::nothing;
  std::string text;
  std::vector<Node> children;
  std::vector<double> weights; // of alternatives, each above 0
  std::vector<Tag> tags;
  Place place;
};

struct Rule {
  std::string name;
  bool is_public = false;
  Node body;
  Place place;
};

struct Grammar {
  std::string name;
  std::vector<Rule> rules;
};

// Every error there is goes to `errors`, with its place in the file that the
// grammar stands in; what could be read comes back all the same.
Grammar parse(const GrammarModel& model, std::vector<Error>& errors);

} // namespace parlour::adapters::nlu::jsgf
