// lost-timer: one that is over before it rings.
#include <algorithm>

#include "runtime/base/clock.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

bool leaves_state(const Element& element) {
  return element.is("transit") || element.is("pop");
}

class TimeLint {
public:
  TimeLint(const Subject& subject, Findings& findings)
      : sessions_(subject.program.settings.sessions), findings_(findings) {}

  // One that repeats keeps no session open, and would ring when it is over.
  void timer(const Element& element) {
    const auto after = parse_duration(element.value("after"));
    if (after && *after >= sessions_.closes_after &&
        element.value("repeat") == "true" && !element.attribute("keeps-open"))
      warn(findings_, "lost-timer", element.position,
           "where nobody speaks, the session closes before this timer rings "
           "(closes-after), as it repeats; say keeps-open=\"true\", or "
           "\"false\" if that is right");
  }

  // Statements that leave the state, and so end the timers beside them.
  void block(const Element& element) {
    const auto& statements = element.children;
    if (!std::any_of(statements.begin(), statements.end(), leaves_state))
      return;
    for (const auto& statement : statements)
      if (statement.is("timer") && !statement.attribute("ends-with"))
        warn(findings_, "lost-timer", statement.position,
             "this timer ends with the state that is left here; one that is "
             "to ring has ends-with=\"session\"");
  }

private:
  const SessionSettings& sessions_;
  Findings& findings_;
};

} // namespace

void lint_time(const Subject& subject, Findings& findings) {
  if (!subject.settings)
    return;
  TimeLint lint(subject, findings);
  walk(subject, false, [&](const Element& element, const ElementRule& rule) {
    if (element.is("timer") && is_statement(rule))
      lint.timer(element);
    else if (element.is("state"))
      walk(element, rule, [&](const Element& inside, const ElementRule&) {
        lint.block(inside);
      });
  });
}

} // namespace parlour::script::lint
