// unused-function.
#include "script/compiler/name_collector.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

struct Calls {
  std::multiset<std::string> names; // once for each body that calls it
  bool computed = false;
};

bool is_computed_call(const Element& element) {
  return element.is("call") && is_computed(element.value("function"));
}

// A function's calls of itself do not count.
Calls calls_of(const Subject& subject) {
  Calls calls;
  std::vector<std::pair<const Element*, std::string>> functions;
  walk(subject, true, [&](const Element& element, const ElementRule& rule) {
    calls.computed |= is_computed_call(element);
    Mentions mentions;
    mentions_of(element, rule, mentions);
    calls.names.insert(mentions.calls.begin(), mentions.calls.end());
    if (!element.is("function"))
      return;
    // Taken off again: what it calls by its own name.
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

void lint_functions(const Subject& subject, Findings& findings) {
  const auto calls = calls_of(subject);
  if (!subject.is_whole() || calls.computed)
    return;
  walk(subject, false, [&](const Element& element, const ElementRule&) {
    const auto name = element.value("name");
    if (element.is("function") && name != "main" && !calls.names.count(name))
      warn(findings, "unused-function", element.position,
           "nothing calls the function '" + name +
               "'; call it by <call function=\"" + name +
               "\"/>, or take it out");
  });
}

} // namespace parlour::script::lint
