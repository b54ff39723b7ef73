// Helpers of the compilers of declarations.

#include "script/compiler/compilation.hpp"

#include <algorithm>

#include "script/compiler/name_collector.hpp"

namespace parlour::script {

Names without_variables(const Compilation& compilation) {
  auto names = compilation.names;
  std::erase_if(names.variables, [&](const auto& entry) {
    return !compilation.program.variables[entry.second].is_constant;
  });
  return names;
}

std::vector<std::string> split_names(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t start = 0; start <= text.size();) {
    const auto end = std::min(text.find(',', start), text.size());
    auto name = collapsed(std::string_view(text).substr(start, end - start));
    if (!name.empty())
      names.push_back(std::move(name));
    start = end + 1;
  }
  return names;
}

std::vector<CodeId> compile_values(const Element* parent,
                                   const BodyContext& context,
                                   Compilation& compilation) {
  std::vector<CodeId> values;
  if (!parent)
    return values;
  for (const auto& value : parent->children) {
    if (const auto* expression = value.attribute("expr"))
      values.push_back(compilation.bodies.expression(*expression, context));
    else
      values.push_back(compilation.bodies.text(collapsed(value.text),
                                               value.text_position, context));
  }
  return values;
}

CodeId compile_child(const Element& parent, const char* name,
                     const BodyContext& context, Compilation& compilation) {
  const auto* child = parent.child(name);
  if (!child)
    return no_code;
  auto inside = context;
  inside.name += " <" + child->name + ">";
  return compilation.bodies.body(*child, inside);
}

void compile_functions(const Element& holder, const FunctionNames& functions,
                       BodyContext context, Compilation& compilation) {
  for_each_function(holder, [&](const Element& element) {
    const auto name = element.value("name");
    const auto found = functions.find(name);
    if (found == functions.end() || found->second.position != element.position)
      return; // a duplicate or a built-in's name: reported
    context.name = "function " + name;
    compilation.bodies.function(element, found->second.code, context);
  });
}

void check_grammar(const Element& element, Compilation& compilation) {
  const auto* attribute = element.attribute("grammar");
  const auto& known = compilation.grammars;
  if (!attribute || attribute->value.empty() ||
      std::find(known.begin(), known.end(), attribute->value) != known.end())
    return;
  compilation.findings.error(attribute->value_position,
                             "there is no grammar '" + attribute->value + "'" +
                                 did_you_mean(attribute->value, known));
}

} // namespace parlour::script
