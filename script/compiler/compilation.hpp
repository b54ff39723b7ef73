// Compilation: what the compilers of the various declarations share while one
// application is compiled.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/text/names.hpp"
#include "script/compiler/code/body_compiler.hpp"
#include "script/program/program.hpp"
#include "script/source/findings.hpp"

namespace parlour::script {

// References into the objects of one compilation; short-lived.
struct Compilation {
  Program& program;
  const Names& names;
  Findings& findings;
  BodyCompiler& bodies;
  // Every name that can be the source of a message: roles, aliases, components
  // and agents.
  std::vector<std::string> sources;
  std::vector<std::string> grammars;
  std::vector<std::string> raised{}; // events that a <fire> raises
};

// The names that code outside of sessions sees: phrases and routes have no
// variables, only constants.
Names without_variables(const Compilation& compilation);

// Splits "a, b" at commas and trims the parts.
std::vector<std::string> split_names(const std::string& text);

// The keys of a map, as candidates for "did you mean".
template <class Map>
std::vector<std::string> keys_of(const Map& map) {
  std::vector<std::string> keys;
  for (const auto& entry : map)
    keys.push_back(entry.first);
  return keys;
}

// Compiles each <value> of `parent`: a text with {expr}, or an expression.
std::vector<CodeId> compile_values(const Element* parent,
                                   const BodyContext& context,
                                   Compilation& compilation);

// Compiles the body of a child element; no_code if there is none.
CodeId compile_child(const Element& parent, const char* name,
                     const BodyContext& context, Compilation& compilation);

// Compiles the functions of `holder` into the code that was reserved for them.
void compile_functions(const Element& holder, const FunctionNames& functions,
                       BodyContext context, Compilation& compilation);

// Reports a `grammar` attribute that names no grammar.
void check_grammar(const Element& element, Compilation& compilation);

} // namespace parlour::script
