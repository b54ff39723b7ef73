// The examples of the reference as data, with the rule or page that explains
// each thing at length: element_examples.def, function_examples.def and
// role_examples.def. Tests check that each is correct and that none is missing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "script/xml/element_table.hpp"

namespace parlour::tools {

// What a file needs around an example to be complete.
// nothing: it is a whole file; script: inside <dialogue>; statements: inside
// the <Entrance> of a state.
enum class Around : unsigned char { nothing, script, statements };

// One example may serve several elements.
struct ElementExample {
  std::vector<std::string> names; // "var@arguments" if ambiguous
  std::string told;               // a rule or a page
  Around around = Around::nothing;
  std::string xml; // without the last line end
};

const std::vector<ElementExample>& element_examples();

// The name under which an element's example is found: "var@arguments" (with the
// content it is part of) if several elements are called "var", otherwise the
// element's name.
std::string example_name(const script::ElementRule& rule);

// The example of an element; null if there is none.
const ElementExample* example_of(const script::ElementRule& rule);

// An expression and its result as text.
struct Trial {
  std::string expression;
  std::string result;
};

// The parameters and examples of a function.
struct FunctionExample {
  std::string name;
  // "text, start, count?": `?` marks an optional one; "..." means any number.
  std::string parameters;
  std::string told; // a rule of the language
  std::vector<Trial> trials{};
};

const std::vector<FunctionExample>& function_examples();

// The example of a function; null if there is none.
const FunctionExample* example_of(std::string_view function);

struct RoleExample {
  std::string role; // or a source of the platform's own
  Around around = Around::nothing;
  std::string xml;
};

const std::vector<RoleExample>& role_examples();

// The example of a role; null if there is none.
const RoleExample* role_example(std::string_view role);

} // namespace parlour::tools
