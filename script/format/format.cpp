// The layout is written from the layout tree; afterwards format_source proves
// that the result has the same meaning and the same comments.

#include "script/format/format.hpp"

#include <algorithm>
#include <utility>

#include "runtime/base/text/utf8.hpp"
#include "script/format/layout_tree.hpp"
#include "script/xml/element_table.hpp"
#include "script/xml/source_reader.hpp"

namespace parlour::script {

namespace {

constexpr std::size_t width = 80; // code points
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

// The width of a text in characters.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(),
                    [](char byte) { return !continues_code_point(byte); }));
}

// Whether blanks alone can have a meaning inside of the element. For unknown
// elements they may.
bool may_hold_text(std::string_view name) {
  bool known = false;
  for (const auto& rule : element_table()) {
    if (!same_name(rule.name, name))
      continue;
    known = true;
    if (rule.holds_text())
      return true;
  }
  return !known;
}

// Writes a layout tree. Each element gets a line of its own with two blanks for
// each level; an element that was written in one line stays so if it fits. Text
// and comments are never touched.
class Layout {
public:
  explicit Layout(std::string_view line_end) : line_end_(line_end) {}

  std::string document(const std::vector<LayoutNode>& nodes) {
    children(nodes, 0);
    out_ += line_end_;
    return std::move(out_);
  }

private:
  void children(const std::vector<LayoutNode>& nodes, std::size_t indent);
  void node(const LayoutNode& node, std::size_t indent);
  void element(const LayoutNode& node, std::size_t indent);
  void start_tag(const LayoutNode& node, std::string_view close);
  void new_line(std::size_t indent) {
    if (!out_.empty())
      out_ += line_end_;
    out_.append(indent, ' ');
  }
  // The column of the next character, in characters.
  std::size_t column() const {
    const auto line = out_.rfind('\n') + 1; // npos + 1 is 0
    return columns(std::string_view(out_).substr(line));
  }

  std::string_view line_end_;
  std::string out_;
};

bool is_comment(const LayoutNode& node) {
  return node.raw.starts_with("<!--"); // not an instruction
}

// Whether it can be written as <a/>: nothing inside, or blanks without a
// meaning.
bool is_empty(const LayoutNode& node) {
  return node.children.empty() &&
         (node.inside.empty() || !may_hold_text(node.name));
}

// The start tag in one line.
std::string tag_in_one_line(const LayoutNode& node, std::string_view close) {
  auto text = "<" + std::string(node.name);
  for (std::size_t i = 0; i < node.names.size(); ++i)
    text.append(" ").append(node.names[i]).append("=").append(node.values[i]);
  return text.append(close);
}

// The whole element in one line, if it was written so.
std::string in_one_line(const LayoutNode& node) {
  if (node.kind != LayoutNode::Kind::element)
    return std::string(node.raw);
  if (is_empty(node))
    return tag_in_one_line(node, "/>");
  auto text = tag_in_one_line(node, ">");
  if (node.has_text() || node.children.empty())
    text += node.inside;
  else
    for (const auto& child : node.children)
      text += in_one_line(child);
  return text + "</" + std::string(node.name) + ">";
}

// Writes the start tag with as many attributes in each line as fit, aligned
// below the first attribute.
void Layout::start_tag(const LayoutNode& node, std::string_view close) {
  const auto line = tag_in_one_line(node, close);
  if (column() + columns(line) <= width &&
      line.find('\n') == std::string::npos) {
    out_ += line;
    return;
  }
  out_.append("<").append(node.name);
  const auto indent = column() + 1;
  for (std::size_t i = 0; i < node.names.size(); ++i) {
    const auto attribute =
        std::string(node.names[i]) + "=" + std::string(node.values[i]);
    const auto last = i + 1 == node.names.size() ? close.size() : 0;
    const auto first_line = attribute.substr(0, attribute.find('\n'));
    if (i > 0 && column() + 1 + columns(first_line) + last > width)
      new_line(indent);
    else
      out_ += ' ';
    out_ += attribute;
  }
  out_ += close;
}

// Three cases: empty, with text inside (kept as it is), or with child elements.
void Layout::element(const LayoutNode& node, std::size_t indent) {
  if (is_empty(node))
    return start_tag(node, "/>");
  const bool as_it_is = node.has_text() || node.children.empty();
  if (!as_it_is && node.is_one_line()) {
    const auto line = in_one_line(node);
    if (node.keeps_line || column() + columns(line) <= width) {
      out_ += line;
      return;
    }
  }
  start_tag(node, ">");
  if (as_it_is) {
    out_ += node.inside;
  } else {
    children(node.children, indent + 2);
    if (!node.end_keeps_line)
      new_line(indent);
  }
  out_.append("</").append(node.name).append(">");
}

// Comments and texts are copied as they are.
void Layout::node(const LayoutNode& node, std::size_t indent) {
  if (node.kind == LayoutNode::Kind::element)
    element(node, indent);
  else
    out_ += node.raw;
}

// A comment stays behind what it followed in its line, and an element stays
// behind a comment. On a line where a warning is allowed everything stays
// together, because the allowance counts by line.
void Layout::children(const std::vector<LayoutNode>& nodes,
                      std::size_t indent) {
  const LayoutNode* previous = nullptr;
  for (const auto& one : nodes) {
    // Whether it stays in the line of the previous node.
    const bool beside = one.on_same_line && !out_.empty() &&
                        (one.keeps_line || is_comment(one) ||
                         (previous && is_comment(*previous)));
    if (one.after_empty_line)
      out_ += line_end_;
    if (beside) // comments may stand below each other
      out_ += is_comment(one) && !one.gap.empty() ? one.gap : " ";
    else
      new_line(indent);
    node(one, indent);
    previous = &one;
  }
}

} // namespace

// All comments in order, to prove that none was lost.
namespace {

std::vector<std::string_view>
comments_of(const std::vector<LayoutNode>& nodes) {
  std::vector<std::string_view> comments;
  for (const auto& node : nodes) {
    if (node.kind == LayoutNode::Kind::comment)
      comments.push_back(node.raw);
    const auto inside = comments_of(node.children);
    comments.insert(comments.end(), inside.begin(), inside.end());
  }
  return comments;
}

} // namespace

// Positions do not count.
bool means_the_same(const Element& a, const Element& b) {
  const auto same_attribute = [](const Attribute& one, const Attribute& other) {
    return one.name == other.name && one.value == other.value;
  };
  return a.name == b.name && a.text == b.text &&
         std::equal(a.attributes.begin(), a.attributes.end(),
                    b.attributes.begin(), b.attributes.end(), same_attribute) &&
         std::equal(a.children.begin(), a.children.end(), b.children.begin(),
                    b.children.end(), means_the_same);
}

// The result is read again and compared with the original, so a mistake in the
// layout can never change a script.
std::optional<std::string>
format_source(const std::string& text, std::uint16_t file, Findings& findings) {
  const auto before = read_source(text, file, findings);
  if (!before || findings.has_errors())
    return std::nullopt;
  const bool marked = text.starts_with(byte_order_mark);
  const auto body =
      std::string_view(text).substr(marked ? byte_order_mark.size() : 0);
  const auto* line_end = text.find("\r\n") == std::string::npos ? "\n" : "\r\n";
  const auto tree = layout_tree(body);
  const auto formatted = Layout(line_end).document(tree);
  Findings none;
  const auto after = read_source(formatted, none.add_file(""), none);
  if (after && means_the_same(*before, *after) &&
      comments_of(tree) == comments_of(layout_tree(formatted)))
    return (marked ? std::string(byte_order_mark) : std::string()) + formatted;
  findings.error({file, 0, 0}, "this file cannot be formatted without changing "
                               "what it means; please report it");
  return std::nullopt;
}

} // namespace parlour::script
