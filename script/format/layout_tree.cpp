// A recursive parser over the text. The depth is limited, because only texts
// that read_source has accepted come here.

#include "script/format/layout_tree.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "script/xml/allowances.hpp"

namespace parlour::script {

namespace {

constexpr auto npos = std::string_view::npos;
constexpr std::string_view blanks = " \t\r\n";

// Constructs other than elements, with what ends them.
struct Special {
  std::string_view begin;
  std::string_view end;
  LayoutNode::Kind kind;
};
constexpr Special specials[] = {
    {"<!--", "-->", LayoutNode::Kind::comment},
    {"<![CDATA[", "]]>", LayoutNode::Kind::text},
    {"<?", "?>", LayoutNode::Kind::comment},
};

// A parser for text that is known to be well-formed: every end that it looks
// for exists, so it needs no errors.
class Reader {
public:
  explicit Reader(std::string_view text)
      : text_(text), allowances_(read_allowances(text)) {}

  // Siblings up to an end tag or the end of the text. What lies between two
  // nodes (blanks, line ends) is recorded in the second one.
  std::vector<LayoutNode> nodes() {
    std::vector<LayoutNode> nodes;
    for (;;) {
      const auto from = at_;
      at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
      if (at_ == text_.size() || text_.substr(at_).starts_with("</"))
        return nodes;
      // One line end means a new line, more than one an empty line between.
      const auto lines = line_ends(from, at_);
      const auto begin = at_;
      const bool kept = is_kept();
      auto node = read();
      node.on_same_line = lines == 0 && from > 0;
      if (node.on_same_line)
        node.gap = text_.substr(from, begin - from);
      node.after_empty_line = lines > 1 && !nodes.empty();
      node.keeps_line = kept;
      nodes.push_back(std::move(node));
    }
  }

private:
  std::ptrdiff_t line_ends(std::size_t from, std::size_t to) const {
    return std::count(text_.begin() + static_cast<std::ptrdiff_t>(from),
                      text_.begin() + static_cast<std::ptrdiff_t>(to), '\n');
  }
  // Whether a comment allows a warning on the line of the current offset. Lines
  // are counted as far as the offset only, since offsets only grow.
  bool is_kept() {
    line_ += static_cast<std::uint32_t>(line_ends(counted_, at_));
    counted_ = at_;
    return std::any_of(
        allowances_.begin(), allowances_.end(), [this](const Allowance& one) {
          return !one.whole_file && one.first <= line_ && line_ <= one.last;
        });
  }

  // One node, by its first characters.
  LayoutNode read() {
    const auto rest = text_.substr(at_);
    for (const auto& special : specials)
      if (rest.starts_with(special.begin))
        return plain(special.kind, rest.find(special.end) + special.end.size());
    if (rest.starts_with('<'))
      return element();
    return plain(LayoutNode::Kind::text, std::min(rest.find('<'), rest.size()));
  }

  // A node of this many bytes without structure.
  LayoutNode plain(LayoutNode::Kind kind, std::size_t length) {
    LayoutNode node;
    node.kind = kind;
    node.raw = text_.substr(at_, length);
    at_ += node.raw.size();
    return node;
  }

  // Reads up to one of the characters `ends`.
  std::string_view take_until(std::string_view ends) {
    const auto end = std::min(text_.find_first_of(ends, at_), text_.size());
    const auto taken = text_.substr(at_, end - at_);
    at_ = end;
    return taken;
  }

  // The value is kept with its quotes and entities.
  void attribute(LayoutNode& node) {
    node.names.push_back(take_until("= \t\r\n"));
    at_ = std::min(text_.find_first_of("\"'", at_), text_.size() - 1);
    const auto end =
        std::min(text_.find(text_[at_], at_ + 1), text_.size() - 1);
    node.values.push_back(text_.substr(at_, end + 1 - at_));
    at_ = end + 1;
  }

  // Attributes, then the children up to the end tag, which nodes() leaves.
  LayoutNode element() {
    LayoutNode node;
    const auto begin = at_++;
    node.name = take_until(" \t\r\n/>");
    for (;;) {
      at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
      if (at_ == text_.size() || text_[at_] == '>' || text_[at_] == '/')
        break;
      attribute(node);
    }
    if (text_.substr(at_).starts_with("/>")) {
      at_ += 2;
    } else {
      const auto from = ++at_;
      node.children = nodes();
      node.inside = text_.substr(from, at_ - from);
      node.end_keeps_line =
          is_kept() && !node.children.empty() &&
          line_ends(text_.find_last_not_of(blanks, at_ - 1), at_) == 0;
      at_ = std::min(text_.find('>', at_), text_.size() - 1) + 1;
    }
    node.raw = text_.substr(begin, at_ - begin);
    return node;
  }

  std::string_view text_;
  std::vector<Allowance> allowances_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1; // of the place counted_
  std::size_t counted_ = 0;
};

} // namespace

bool LayoutNode::has_text() const {
  return std::any_of(children.begin(), children.end(), [](const auto& child) {
    return child.kind == Kind::text;
  });
}

std::vector<LayoutNode> layout_tree(std::string_view text) {
  return Reader(text).nodes();
}

} // namespace parlour::script
