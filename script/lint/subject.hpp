// Subject: what the passes of the lint look at, and how they walk through it.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "script/compiler/code/code_builder.hpp"
#include "script/expression/expression.hpp"
#include "script/lint/lint.hpp"
#include "script/xml/element_table.hpp"

namespace parlour::script::lint {

struct Subject {
  const Program& program;
  const std::vector<Document>& documents;
  const Element* settings; // null: a file by itself
  const Options& options;

  // Whether nothing can be missing: an application, or a file that is run.
  bool is_whole() const {
    return settings || program.functions.count("main") > 0;
  }
};

// Calls `visit(element, rule)` for the element, which `rule` is for, and for
// all inside of it.
using Visit = std::function<void(const Element&, const ElementRule&)>;
void walk(const Element& element, const ElementRule& rule, const Visit& visit);

// The same for every document of the application itself (or of the platform
// too), and for the settings.
void walk(const Subject& subject, bool platform, const Visit& visit);

// The trees of all expressions in an element's own attributes and text: of
// those that are one, and of those embedded in text; with where each stands.
using VisitNode = std::function<void(const Node&, const Source&)>;
void visit_nodes(const Element& element, const ElementRule& rule,
                 const VisitNode& visit);
void visit_expressions(const Element& element, const ElementRule& rule,
                       const std::function<void(const Node&)>& visit);

// Calls `visit` for the node and all below it.
void visit_below(const Node& node,
                 const std::function<void(const Node&)>& visit);

// Names of variables that an element's own attributes read, and functions that
// they call. What may be a text or an expression counts as both.
struct Mentions {
  std::set<std::string> names;
  std::set<std::string> calls;
  std::set<std::string> slots; // this.Name
};
void mentions_of(const Node& node, Mentions& mentions);
void mentions_of(const Element& element, const ElementRule& rule,
                 Mentions& mentions);
// All inside of the element too.
Mentions all_mentions(const Element& element, const ElementRule& rule);

// The rule of a document's or the settings' outermost element.
const ElementRule& rule_of(const Element& root);

// Every name that anything in the application gives to a variable; and "this".
std::set<std::string> declared_names(const Subject& subject);

bool is_statement(const ElementRule& rule);
bool is_computed(std::string_view text); // has a brace

void warn(Findings& findings, const char* lint, Position position,
          std::string message);
void warn(Findings& findings, const char* lint, const Spot& spot,
          std::string message);

} // namespace parlour::script::lint
