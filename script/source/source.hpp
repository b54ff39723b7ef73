// The XML of an application as a tree that knows where everything stands
// (language rule 1.3). Reading reports every finding; it never throws.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace parlour::script {

// Line and column (in code points) count from 1. `file` indexes the
// application's list of files.
struct Position {
  std::uint16_t file = 0;
  std::uint32_t line = 0;
  std::uint32_t column = 0;

  bool operator==(const Position&) const = default;
};

struct Attribute {
  std::string name;
  std::string value;       // entities replaced
  Position position;       // of the name
  Position value_position; // of the value's first character
};

struct Element {
  std::string name; // as written
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  std::string text;  // character data directly inside, CDATA included
  Position position; // of the start tag
  Position text_position;

  // Whether it is called that, the case of the first letter aside.
  bool is(std::string_view other) const;
  // Null where there is none.
  const Attribute* attribute(std::string_view attribute_name) const;
  // Empty where there is none.
  std::string value(std::string_view attribute_name) const;
  // The first child of that name, without regard to its first letter's case.
  const Element* child(std::string_view child_name) const;
};

// Element names are equal without regard to the case of their first letter
// (language rule 1.4).
bool same_name(std::string_view a, std::string_view b);

// Trimmed, each run of white space one blank, as a <value> is read.
std::string collapsed(std::string_view text);

} // namespace parlour::script
