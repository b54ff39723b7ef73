// Expressions (language rule 3) as a small tree, and the parser that makes it.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "script/support/block_cache.hpp"

namespace parlour::script {

enum class NodeKind : std::uint8_t {
  unknown,
  boolean, // flag
  integer,
  number,
  string, // text
  name,   // text
  list,
  map,   // keys, children; flag
  index, // children: container, key
  field, // text; child: container
  call,  // text; children: arguments
  negate,
  invert,
  binary, // operation
  both,   // and
  either, // or
  choice, // ?:
};

enum class Operator : std::uint8_t {
  equal,
  unequal,
  less,
  less_equal,
  greater,
  greater_equal,
  in,
  add,
  subtract,
  multiply,
  divide,
  modulo,
};

struct Node;
using NodePointer = std::unique_ptr<Node>;

// Many of them come and go while an application is compiled.
struct Node {
  static void* operator new(std::size_t bytes) {
    return BlockCache::take(bytes);
  }
  static void operator delete(void* block, std::size_t bytes) {
    BlockCache::give(block, bytes);
  }

  NodeKind kind = NodeKind::unknown;
  Operator operation = Operator::equal;
  bool flag = false;        // of a map: a key stands in quotes
  std::uint32_t offset = 0; // bytes from the text's beginning; a field's name
  std::int64_t integer = 0;
  double number = 0;
  std::string text;
  std::vector<std::string> keys;
  std::vector<NodePointer> children;
};

// Either the tree, or what is wrong and where.
struct Parsed {
  NodePointer node; // null: not well-formed
  std::string error;
  std::uint32_t error_offset = 0;
};

Parsed parse_expression(std::string_view text);
// A word of the language, such as `and`: no variable can have this name.
bool is_reserved(std::string_view word);
// "a, b, c" as one list node.
Parsed parse_arguments(std::string_view text);

} // namespace parlour::script
