// XmlWriter: writes elements as indented text.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace parlour::script {

// Escapes attribute values and texts. Depth follows the nesting of element().
class XmlWriter {
public:
  using Attributes =
      std::initializer_list<std::pair<std::string_view, std::string_view>>;

  XmlWriter() : text_("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n") {}

  // Writes <name a="b">, what `inside` writes, and </name>.
  template <class Inside>
  void element(std::string_view name, Attributes attributes, Inside inside) {
    start(name, attributes, ">\n");
    ++depth_;
    inside();
    --depth_;
    indent();
    text_.append("</").append(name).append(">\n");
  }
  // Writes <name a="b"/>.
  void empty(std::string_view name, Attributes attributes = {}) {
    start(name, attributes, "/>\n");
  }
  // Writes <name>text</name> in one line.
  void text(std::string_view name, std::string_view content,
            Attributes attributes = {});

  // The document written so far.
  std::string take() {
    return std::move(text_);
  }

private:
  void start(std::string_view name, Attributes attributes,
             std::string_view end);
  void indent() {
    text_.append(2 * depth_, ' ');
  }
  void escaped(std::string_view content);

  std::string text_;
  std::size_t depth_ = 0;
};

} // namespace parlour::script
