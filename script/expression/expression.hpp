// Expressions (language rule 3): the syntax tree and the parser that makes it.
// The parser evaluates nothing and knows no names; script/compiler/code
// compiles the tree. An example:
//
//   auto parsed = parse_expression("count + 1");
//   if (!parsed.node)
//     report(parsed.error, parsed.error_offset);
//
// The tree of `a.b[1] + f(x)`:
//
//   binary add
//     index
//       field b
//         name a
//       integer 1
//     call f
//       name x
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "script/expression/syntax_fault.hpp"
#include "script/support/block_cache.hpp"

namespace parlour::script {

// The kinds of nodes; behind each the members of Node that it uses.
enum class NodeKind : std::uint8_t {
  unknown,
  boolean, // flag
  integer,
  number,
  string, // text
  name,   // text
  list,
  map,   // keys, children; flag: a key stands in quotes
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

// In the order of the first signs of the lexer, which are cast to it.
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

// A node owns its children. Nodes come from the thread's BlockCache, as
// compiling an application makes and frees many of them.
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
  std::uint32_t offset = 0; // in bytes of the text; of a field: its name
  std::int64_t integer = 0;
  double number = 0;
  std::string text;
  std::vector<std::string> keys;
  std::vector<NodePointer> children;
};

// The result of parsing: either a tree, or the first error and its place.
struct Parsed {
  NodePointer node; // null if the text is not well-formed
  std::string error;
  std::uint32_t error_offset = 0;
  SyntaxFault fault = SyntaxFault::none;
  char sign = '\0'; // what is missing, or the first character not expected
};

// Takes time linear in the text. Nesting and the number of operators in a row
// are limited, so neither the parser nor any later walk over the tree can
// exhaust the stack.
Parsed parse_expression(std::string_view text);
// Whether the word belongs to the language, such as `and`; no variable may have
// it as its name.
bool is_reserved(std::string_view word);
// Parses "a, b, c" into one list node.
Parsed parse_arguments(std::string_view text);

} // namespace parlour::script
