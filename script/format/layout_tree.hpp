// LayoutTree: a well-formed text as a tree for laying it out anew. Unlike the
// tree of source.hpp it keeps comments, quotes, entities and empty lines. All
// members are views into the text, which must outlive the tree.
#pragma once

#include <string_view>
#include <vector>

namespace parlour::script {

// An element, a comment or a text, with its surroundings.
struct LayoutNode {
  enum class Kind : unsigned char { element, comment, text };
  Kind kind = Kind::element;
  std::string_view raw; // the whole node
  // Of an element:
  std::string_view name;
  std::vector<std::string_view> names;  // of its attributes
  std::vector<std::string_view> values; // with their quotes
  std::vector<LayoutNode> children;     // without blanks between
  std::string_view inside;              // between its tags
  // How it stood behind the previous node:
  bool on_same_line = false;
  std::string_view gap; // the blanks between, on the same line
  bool after_empty_line = false;
  // Whether a warning is allowed on its line; everything on such a line stays
  // together.
  bool keeps_line = false;
  bool end_keeps_line = false; // its end tag, behind what is inside

  bool is_one_line() const {
    return raw.find('\n') == std::string_view::npos;
  }
  // Whether it contains text; its inside is then left as it is.
  bool has_text() const;
};

// The top-level nodes: the root, comments, and instructions, which count as
// comments.
std::vector<LayoutNode> layout_tree(std::string_view text);

} // namespace parlour::script
