// lost-timer: a timer ends before it rings.
//
//   <Entrance>
//     <timer name="t" after="1s">…</timer>    ends with the state …
//     <transit state="B"/>                    … which is left here
//
// Both are about timers that end quietly (language rules 10.5 and 10.6).
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
  TimeLint(const LintContext& context, Findings& findings)
      : sessions_(context.program.settings.sessions), findings_(findings) {}

  // A repeating timer keeps no session open (language rule 10.6), so one whose
  // period is longer than the session's silence would never ring.
  void timer(const Element& element) {
    const auto after = parse_duration(element.value("after"));
    if (after && *after >= sessions_.closes_after &&
        element.value("repeat") == "true" && !element.attribute("keeps-open"))
      warn(findings_, "lost-timer", element.position,
           "where nobody speaks, the session closes before this timer rings "
           "(closes-after), as it repeats; say keeps-open=\"true\", or "
           "\"false\" if that is right");
  }

  // Statements that leave the state end the timers that are set beside them
  // (language rule 10.5).
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

// Blocks are examined in states only, as other timers outlive a <transit>.
void lint_time(const LintContext& context, Findings& findings) {
  if (!context.settings)
    return;
  TimeLint lint(context, findings);
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    if (element.is("timer") && is_statement(rule))
      lint.timer(element);
    else if (element.is("state"))
      walk(element, rule, [&](const Element& inside, const ElementRule&) {
        lint.block(inside);
      });
  });
}

} // namespace parlour::script::lint
