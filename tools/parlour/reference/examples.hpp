// The examples of the reference, and where each thing is told of at length:
// element_examples.def and function_examples.def.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "script/xml/element_table.hpp"

namespace parlour::tools {

// What a file holds around an example.
enum class Around : unsigned char { nothing, script, statements };

struct ElementExample {
  std::vector<std::string> names; // "var", or "var@arguments" of several
  std::string told;               // "5.1": a rule of the language; or a page
  Around around = Around::nothing;
  std::string xml; // without the last line's end
};

const std::vector<ElementExample>& element_examples();

// "var", or where several elements have that name "var@arguments": with what
// it is part of.
std::string example_name(const script::ElementRule& rule);

// Null where there is none.
const ElementExample* example_of(const script::ElementRule& rule);

// An expression and what it gives, as it is printed.
struct Trial {
  std::string expression;
  std::string result;
};

struct FunctionExample {
  std::string name;
  std::string parameters; // "text, start, count?"; "...": any number
  std::string told;       // a rule of the language
  std::vector<Trial> trials{};
};

const std::vector<FunctionExample>& function_examples();

// Null where there is none.
const FunctionExample* example_of(std::string_view function);

} // namespace parlour::tools
