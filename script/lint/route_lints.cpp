// endless-relay: relays without a condition lead back to where they begin.
//
//   <relay source="A" command="X" to="B"/>
//   <relay source="B" command="X" to="A"/>     for ever, if both answer with X
#include <algorithm>

#include "runtime/message/roles.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Relays form a graph: one follows another if it relays what that one sends.
class RouteLint {
public:
  explicit RouteLint(const LintContext& context) : context_(context) {}

  // The relay that returns the message to the sender of `route` after any
  // number of steps; null if none does.
  const Route* leads_back(const Route& route) const {
    std::vector<const Route*> seen{&route};
    for (std::size_t next = 0; next < seen.size(); ++next)
      for (const auto& after : context_.program.routes) {
        if (!follows(after, *seen[next]))
          continue;
        if (&after == &route)
          return seen[next];
        if (std::ranges::find(seen, &after) == seen.end())
          seen.push_back(&after);
      }
    return nullptr;
  }

private:
  // Whether the message that `before` sends would be relayed by `after`,
  // provided that its receiver answers with the same event.
  bool follows(const Route& after, const Route& before) const {
    const auto& sent = before.as.empty() ? before.command : before.as;
    return is_sure(after) && is_sure(before) &&
           (after.command == "*" || sent == "*" || after.command == sent) &&
           std::ranges::any_of(before.to, [&](const std::string& sink) {
             return is_same(sink, after.source);
           });
  }

  // Conditions may end a ring, so only relays without one count.
  static bool is_sure(const Route& route) {
    return route.condition == no_code && route.source != "*";
  }

  // Whether a sink is the source, by name or by role.
  bool is_same(std::string sink, const std::string& source) const {
    if (sink.ends_with('*'))
      sink.pop_back();
    return canonical_role(sink) == canonical_role(source) ||
           fills(sink, source) || fills(source, sink);
  }

  // Whether the component has the role, as far as the settings tell.
  bool fills(const std::string& component, const std::string& role) const {
    const auto found = context_.options.component_roles.find(component);
    return found != context_.options.component_roles.end() &&
           std::ranges::count(found->second, canonical_role(role)) > 0;
  }

  const LintContext& context_;
};

} // namespace

void lint_routes(const LintContext& context, Findings& findings) {
  const RouteLint lint(context);
  for (const auto& route : context.program.routes)
    if (const auto* last = lint.leads_back(route))
      warn(findings, "endless-relay", route.position,
           "what " + route.source + " sends is relayed " +
               (last == &route ? std::string("back to it")
                               : "in a ring, back by " + last->source) +
               ", which has no end if it answers in kind; set a condition "
               "with 'if', or relay less");
}

} // namespace parlour::script::lint
