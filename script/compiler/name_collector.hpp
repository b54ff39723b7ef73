// NameCollector: the first pass over an application: everything that has a
// name, before any code is made (language rule 1.7). The second of two equal
// names is the error.
#pragma once

#include <vector>

#include "script/compiler/application_loader.hpp"
#include "script/compiler/code/body_compiler.hpp"

namespace parlour::script {

struct Collected {
  Names names;
  // For each document its own functions.
  std::vector<FunctionNames> functions;
};

// Fills the program's variables, handlers, states and topics (with their
// slots) with names, in file order, and reserves the functions' code.
// Functions of the platform's libraries give way to the application's.
Collected collect_names(const std::vector<Document>& documents,
                        Program& program, Findings& findings);

// The functions directly inside of `holder` and in its <functions>.
FunctionNames collect_functions(const Element& holder, Program& program,
                                Findings& findings);

// Calls `visit` for those functions' elements.
template <class Visit>
void for_each_function(const Element& holder, Visit visit) {
  for (const auto& child : holder.children) {
    if (child.is("function"))
      visit(child);
    else if (child.is("functions"))
      for_each_function(child, visit);
  }
}

} // namespace parlour::script
