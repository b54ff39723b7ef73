// Compilation: what the parts of the declarations' compiler share while an
// application is compiled.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/names.hpp"
#include "script/compiler/code/body_compiler.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

struct Compilation {
  Program& program;
  const Names& names;
  Findings& findings;
  BodyCompiler& bodies;
  // Every source that a message can come from: roles, aliases, components,
  // agents.
  std::vector<std::string> sources;
  std::vector<std::string> grammars;
  std::vector<std::string> raised{}; // events, by <fire>
};

// "a, b" without the blanks.
std::vector<std::string> split_names(const std::string& text);

// The keys of a map.
template <class Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& entry : map)
    keys.push_back(entry.first);
  return keys;
}

// Wordings: each <value> of `parent`, as text with {expr} or an expression.
std::vector<CodeId> compile_values(const Element* parent,
                                   const BodyContext& context,
                                   Compilation& compilation);

// The body of a child element; no_code where there is none.
CodeId compile_child(const Element& parent, const char* name,
                     const BodyContext& context, Compilation& compilation);

// The body of `holder`'s functions, into the code that was reserved for them.
void compile_functions(const Element& holder, const FunctionNames& functions,
                       BodyContext context, Compilation& compilation);

// The grammar that a state or slot names must exist.
void check_grammar(const Element& element, Compilation& compilation);

} // namespace parlour::script
