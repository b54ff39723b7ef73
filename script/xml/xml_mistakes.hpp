// Explains why a text is not well-formed XML (language rule 1.3). The parser
// stops at the first error and knows one place; this finds all mistakes with
// their corrections. It runs only after the parser has failed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

struct XmlMistake {
  std::size_t offset = 0; // in bytes of the text
  std::size_t length = 0; // bytes; 0: the word or tag that begins there
  std::string message;
  // Replaces [offset, offset + length); nothing if no correction is certain.
  std::optional<std::string> replacement{};
};

// In the order of the text; empty if no mistake was found.
std::vector<XmlMistake> find_xml_mistakes(std::string_view text);

} // namespace parlour::script
