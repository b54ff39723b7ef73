// The XML of an application as a tree of elements in which each knows its place
// (language rule 1.3). The tree is plain data without pointers to its file;
// script/xml/source_reader makes it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

// A place in a file. Line and column count from 1, the column in code points;
// line 0 is unknown. `file` is an index into the list of Findings.
struct Position {
  std::uint16_t file = 0;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  bool operator==(const Position&) const = default;
};

// As written in the file, except that entities are replaced in the value.
struct Attribute {
  std::string name;
  std::string value;       // entities replaced
  Position position;       // of the name
  Position value_position; // of the value's first character
};

// Owns its children, and so the whole tree below it.
struct Element {
  std::string name; // as written
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  std::string text;  // character data directly inside, CDATA included
  Position position; // of the start tag
  Position text_position;

  // Whether this is the element's name (language rule 1.4).
  bool is(std::string_view other) const;
  // Returns null if there is no such attribute. Valid while the element is.
  const Attribute* attribute(std::string_view attribute_name) const;
  // The attribute's value; empty if there is no such attribute.
  std::string value(std::string_view attribute_name) const;
  // The first child of this name; null if there is none.
  const Element* child(std::string_view child_name) const;
};

// Whether two names are the same element (language rule 1.4): the case of the
// first letter does not count.
bool same_name(std::string_view a, std::string_view b);

// The text without blanks at its ends, and each run of white space in it as one
// blank. The text of a <value> is read like this.
std::string collapsed(std::string_view text);

} // namespace parlour::script
