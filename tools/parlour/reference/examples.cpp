#include "tools/parlour/reference/examples.hpp"

#include <algorithm>
#include <sstream>

namespace parlour::tools {

namespace {

std::vector<std::string> words_of(const char* text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    words.push_back(word);
  return words;
}

// What a raw string has around its lines.
std::string trimmed(std::string text) {
  const auto first = text.find_first_not_of('\n');
  const auto last = text.find_last_not_of('\n');
  return first == std::string::npos ? "" : text.substr(first, last + 1 - first);
}

} // namespace

const std::vector<ElementExample>& element_examples() {
  static const std::vector<ElementExample> all = [] {
    std::vector<ElementExample> examples;
#define EXAMPLE(names, told, around, xml)                                      \
  examples.push_back({words_of(names), told, Around::around, trimmed(xml)});
#include "tools/parlour/reference/element_examples.def"
#undef EXAMPLE
    return examples;
  }();
  return all;
}

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

} // namespace parlour::tools
