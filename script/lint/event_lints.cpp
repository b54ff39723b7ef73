// unhandled-event: a script raises an event that nothing handles.
//
//   <fire event="Greeted"/>       no <Script><Greeted> anywhere
#include <algorithm>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Whether a reaction to source.event takes an event that a script raised.
bool takes(const std::string& source, const std::string& event,
           const std::string& raised) {
  return (source == "Script" || source == "*") &&
         (event == "*" || same_name(event, raised));
}

bool takes(const std::vector<Reaction>& reactions, const std::string& raised) {
  return std::any_of(reactions.begin(), reactions.end(),
                     [&](const Reaction& one) {
                       return takes(one.source, one.event, raised);
                     });
}

bool is_taken(const Program& program, const std::string& raised) {
  const auto in = [&](const auto& all, auto reactions) {
    return std::any_of(all.begin(), all.end(), [&](const auto& one) {
      return takes(one.*reactions, raised);
    });
  };
  const auto matches = [&](const auto& one) {
    return takes(one.source, one.command, raised);
  };
  return in(program.handlers, &Handler::reactions) ||
         in(program.states, &State::messages) ||
         std::ranges::any_of(program.routes, matches) ||
         std::ranges::any_of(program.openings, matches);
}

} // namespace

// Only for whole applications: a single file does not know who handles its
// events.
void lint_events(const LintContext& context, Findings& findings) {
  if (!context.settings)
    return;
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    const auto* event = is_statement(rule) && element.is("fire")
                            ? element.attribute("event")
                            : nullptr;
    if (!event || is_computed(event->value) ||
        is_taken(context.program, event->value))
      return;
    warn(findings, "unhandled-event", event->value_position,
         "nothing takes the event '" + event->value +
             "'; a handler or state does by <Script><" + event->value + ">…</" +
             event->value + "></Script> in its <messages>");
  });
}

} // namespace parlour::script::lint
