// NameCollector: the first pass over an application. It collects everything
// that has a name before any code is compiled (language rule 1.7). Of two equal
// names the second is the error.
//
// Afterwards each name has an index into the program, by which compiled code
// refers to it.
#pragma once

#include <vector>

#include "script/compiler/application/application_loader.hpp"
#include "script/compiler/code/body_compiler.hpp"

namespace parlour::script {

// The result of the first pass.
struct Collected {
  Names names;
  // The functions of each document.
  std::vector<FunctionNames> functions;
};

// Creates the program's variables, handlers, states and topics with their
// slots, each with its name only, in the order of the files, and reserves an
// empty Code for each function. Functions of the platform's libraries yield to
// functions of the same name in the application.
Collected collect_names(const std::vector<Document>& documents,
                        Program& program, Findings& findings);

// The functions directly in `holder` and in its <functions>.
FunctionNames collect_functions(const Element& holder, Program& program,
                                Findings& findings);

// Calls `visit` for the element of each of those functions.
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
