// The sentence comes from the table of built-in functions, parameters and
// examples from function_examples.def.
#include "tools/parlour/reference/function_entry.hpp"

#include "script/expression/builtins.hpp"
#include "tools/parlour/reference/examples.hpp"

namespace parlour::tools {

namespace {

// A line "expression  ->  result" for each example.
std::string text_of(const std::vector<Trial>& trials) {
  std::vector<std::string> lines;
  for (const auto& trial : trials)
    lines.push_back(trial.expression + "  ->  " + trial.result);
  return listed(lines, "\n");
}

Entry entry_of(const std::string& name) {
  Entry entry{name, name + "()",
              script::builtin(*script::builtin_index(name)).sentence};
  if (const auto* example = example_of(std::string_view(name))) {
    entry.title = name + "(" + example->parameters + ")";
    entry.facts.push_back({"told in", example->told});
    entry.example = text_of(example->trials);
  }
  return entry;
}

} // namespace

std::vector<Entry> function_entries() {
  std::vector<Entry> entries;
  for (const auto& name : script::builtin_names())
    entries.push_back(entry_of(name));
  return entries;
}

} // namespace parlour::tools
