// RulesXml collects the mistakes of a file of rules while it is read.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/error.hpp"

namespace pugi {
class xml_node;
}

namespace parlour::adapters::http {

// Used while one file is read; `text` and `file` must live so long.
// Owned by the reader of the file, and given to the readers of its parts. It
// reports and does not stop: whoever reads decides whether to go on.
class RulesXml {
public:
  RulesXml(std::string_view text, const std::string& file)
      : text_(text), file_(file) {}

  // The line of an element or of an offset into the text, from 1.
  std::uint32_t line_of(const pugi::xml_node& node) const;
  std::uint32_t line_of(std::ptrdiff_t offset) const;
  SourceLocation place_of(const pugi::xml_node& node) const;

  void error(const pugi::xml_node& node, std::string message);
  void error(std::uint32_t line, std::string message);

  // Reports attributes that the element does not have, and needed ones that
  // are missing or empty. False if something is wrong.
  bool check_attributes(const pugi::xml_node& node,
                        std::initializer_list<std::string_view> needed,
                        std::initializer_list<std::string_view> optional = {});
  // Reports an element that has no place here. `known`: what has one.
  void unknown(const pugi::xml_node& node, const std::string& known);

  const std::string& file() const {
    return file_;
  }
  // In the order of their lines, once.
  std::vector<Error> take_errors();
  bool has_errors() const {
    return !errors_.empty();
  }

private:
  std::string_view text_;
  const std::string& file_;
  std::vector<Error> errors_;
};

// The text of an element without the blanks around it; comments are no part.
std::string text_of(const pugi::xml_node& node);

} // namespace parlour::adapters::http
