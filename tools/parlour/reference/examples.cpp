// Reads the .def files into tables when they are first asked for.
#include "tools/parlour/reference/examples.hpp"

#include <algorithm>

#include "runtime/text/words.hpp"

namespace parlour::tools {

namespace {

// Without the line ends that a raw string has around its text.
std::string trimmed(std::string text) {
  const auto first = text.find_first_not_of('\n');
  const auto last = text.find_last_not_of('\n');
  return first == std::string::npos ? "" : text.substr(first, last + 1 - first);
}

} // namespace

const std::vector<ElementExample>& element_examples() {
  static const std::vector<ElementExample> all = [] {
    // EXAMPLE becomes a row of the vector; `around` is an enumerator's name.
    std::vector<ElementExample> examples;
#define EXAMPLE(names, told, around, xml)                                      \
  examples.push_back({split_words(names), told, Around::around, trimmed(xml)});
#include "tools/parlour/reference/element_examples.def"
#undef EXAMPLE
    return examples;
  }();
  return all;
}

// Rows of the element table are told apart by the first content they are part
// of.
std::string example_name(const script::ElementRule& rule) {
  const auto& table = script::element_table();
  const auto same = std::ranges::count_if(
      table, [&](const auto& other) { return other.name == rule.name; });
  return same > 1 ? rule.name + '@' + rule.in.front() : rule.name;
}

const ElementExample* example_of(const script::ElementRule& rule) {
  const auto name = example_name(rule);
  for (const auto& example : element_examples())
    if (std::ranges::count(example.names, name) > 0)
      return &example;
  return nullptr;
}

const std::vector<FunctionExample>& function_examples() {
  static const std::vector<FunctionExample> all = [] {
    // GIVES belongs to the FUNCTION before it.
    std::vector<FunctionExample> examples;
#define FUNCTION(name, parameters, told)                                       \
  examples.push_back({name, parameters, told});
#define GIVES(expression, result)                                              \
  examples.back().trials.push_back({expression, result});
#include "tools/parlour/reference/function_examples.def"
#undef FUNCTION
#undef GIVES
    return examples;
  }();
  return all;
}

const FunctionExample* example_of(std::string_view function) {
  for (const auto& example : function_examples())
    if (example.name == function)
      return &example;
  return nullptr;
}

const std::vector<RoleExample>& role_examples() {
  static const std::vector<RoleExample> all = [] {
    std::vector<RoleExample> examples;
#define EXAMPLE(role, around, xml)                                             \
  examples.push_back({role, Around::around, trimmed(xml)});
#include "tools/parlour/reference/role_examples.def"
#undef EXAMPLE
    return examples;
  }();
  return all;
}

const RoleExample* role_example(std::string_view role) {
  for (const auto& example : role_examples())
    if (example.role == role)
      return &example;
  return nullptr;
}

} // namespace parlour::tools
