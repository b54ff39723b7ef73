// unused-function: nothing calls a function.
//
// `main` counts as called, and a function does not by calling itself.
#include "script/compiler/name_collector.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// The functions that are called anywhere.
struct Calls {
  std::multiset<std::string> names; // one for each calling element
  bool computed = false;
};

bool is_computed_call(const Element& element) {
  return element.is("call") && is_computed(element.value("function"));
}

// Collects all calls, except those by which a function calls itself.
Calls calls_of(const LintContext& context) {
  Calls calls;
  std::vector<std::pair<const Element*, std::string>> functions;
  walk(context, true, [&](const Element& element, const ElementRule& rule) {
    calls.computed |= is_computed_call(element);
    Mentions mentions;
    mentions_of(element, rule, mentions);
    calls.names.insert(mentions.calls.begin(), mentions.calls.end());
    if (!element.is("function"))
      return;
    // Collects the functions that call themselves; one call of each is removed
    // again below.
    const auto name = element.value("name");
    walk(element, rule, [&](const Element& one, const ElementRule& its) {
      Mentions own;
      mentions_of(one, its, own);
      if (own.calls.count(name))
        functions.emplace_back(&element, name);
    });
  });
  for (const auto& [element, name] : functions)
    if (const auto found = calls.names.find(name); found != calls.names.end())
      calls.names.erase(found);
  return calls;
}

} // namespace

// A call by a computed name may call anything, so nothing is certain then.
void lint_functions(const LintContext& context, Findings& findings) {
  const auto calls = calls_of(context);
  if (!context.is_whole() || calls.computed)
    return;
  walk(context, false, [&](const Element& element, const ElementRule&) {
    const auto name = element.value("name");
    if (element.is("function") && name != "main" && !calls.names.count(name))
      warn(findings, "unused-function", element.position,
           "nothing calls the function '" + name +
               "'; call it by <call function=\"" + name +
               "\"/>, or take it out");
  });
}

} // namespace parlour::script::lint
