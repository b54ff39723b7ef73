// LintContext: what all passes read, and how they walk through it.
//
// A pass typically looks like this:
//
//   void lint_things(const LintContext& context, Findings& findings) {
//     walk(context, false, [&](const Element& element,
//                              const ElementRule& rule) {
//       if (is_statement(rule) && element.is("thing") && …)
//         warn(findings, "odd-thing", element.position, "…");
//     });
//   }
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "script/compiler/code/expressions/code_builder.hpp"
#include "script/expression/expression.hpp"
#include "script/lint/lint.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script::lint {

// References to a compilation that outlives the passes.
struct LintContext {
  const Program& program;
  const std::vector<Document>& documents;
  const Element* settings; // null: a single file
  const Options& options;

  // Whether the application is complete: it has settings, or a `main` to be
  // run. Only then the absence of something proves anything.
  bool is_whole() const {
    return settings || program.functions.count("main") > 0;
  }
};

// Calls visit(element, rule) for the element, whose rule is `rule`, and for
// everything inside of it, from the outside in.
using Visit = std::function<void(const Element&, const ElementRule&)>;
void walk(const Element& element, const ElementRule& rule, const Visit& visit);

// The same for all documents of the application, of the platform too if
// `platform` is set, and for the settings.
void walk(const LintContext& context, bool platform, const Visit& visit);

// The same for statements only.
void walk_statements(const LintContext& context, bool platform,
                     const std::function<void(const Element&)>& visit);

// Calls `visit` with the tree of each expression in an element's own attributes
// and text, and with its source: values that are expressions, and expressions
// that are embedded in texts.
using VisitNode = std::function<void(const Node&, const Source&)>;
void visit_nodes(const Element& element, const ElementRule& rule,
                 const VisitNode& visit);
// The same without the source.
void visit_expressions(const Element& element, const ElementRule& rule,
                       const std::function<void(const Node&)>& visit);

// Calls `visit` for the node and every node below it.
void visit_below(const Node& node,
                 const std::function<void(const Node&)>& visit);

// What an element's own attributes mention. A value that may be text or an
// expression counts as both, so that nothing used is taken for unused.
struct Mentions {
  std::set<std::string> names;
  std::set<std::string> calls;
  std::set<std::string> slots; // this.Name
};
void mentions_of(const Node& node, Mentions& mentions);
void mentions_of(const Element& element, const ElementRule& rule,
                 Mentions& mentions);
// The same for the element and everything inside of it.
Mentions all_mentions(const Element& element, const ElementRule& rule);

// The rule of a document's root element.
const ElementRule& rule_of(const Element& root);

// Every name that the application gives to a variable, and "this".
std::set<std::string> declared_names(const LintContext& context);

bool is_statement(const ElementRule& rule);
bool is_computed(std::string_view text); // has a brace

// Adds a warning under the name of its lint.
void warn(Findings& findings, const char* lint, Position position,
          std::string message);
void warn(Findings& findings, const char* lint, const Spot& spot,
          std::string message);

} // namespace parlour::script::lint
