// LayoutTree: a well-formed text as a tree for laying it out anew. Views into
// the text, which must outlive it.
#pragma once

#include <string_view>
#include <vector>

namespace parlour::script {

struct LayoutNode {
  enum class Kind : unsigned char { element, comment, text };
  Kind kind = Kind::element;
  std::string_view raw; // all of it, from its first byte to its last
  // Of an element:
  std::string_view name;
  std::vector<std::string_view> names;  // of its attributes
  std::vector<std::string_view> values; // with their quotes
  std::vector<LayoutNode> children;     // blanks between them left out
  std::string_view inside;              // between its tags; of <a/>: empty
  // How it stood behind what was before it:
  bool on_same_line = false;
  std::string_view gap; // the blanks between, on the same line
  bool after_empty_line = false;
  // A warning is allowed on that line: what stands on it stays together.
  bool keeps_line = false;
  bool end_keeps_line = false; // its end tag, behind what is inside

  bool is_one_line() const {
    return raw.find('\n') == std::string_view::npos;
  }
  // Whether there is text among its children: all of it is left as it is.
  bool has_text() const;
};

// The document's outermost nodes: comments, instructions (as comments), and
// the root.
std::vector<LayoutNode> layout_tree(std::string_view text);

} // namespace parlour::script
