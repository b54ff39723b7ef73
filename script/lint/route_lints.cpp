// endless-relay: relays without a condition that lead back to where they begin.
#include <algorithm>

#include "runtime/base/roles.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

class RouteLint {
public:
  explicit RouteLint(const Subject& subject) : subject_(subject) {}

  // What relays the message at last to who sent it; null: none does.
  const Route* leads_back(const Route& route) const {
    std::vector<const Route*> seen{&route};
    for (std::size_t next = 0; next < seen.size(); ++next)
      for (const auto& after : subject_.program.routes) {
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
  // Whether what one relay sends comes back to be relayed by the other, if who
  // gets it answers in kind.
  bool follows(const Route& after, const Route& before) const {
    const auto& sent = before.as.empty() ? before.command : before.as;
    return is_sure(after) && is_sure(before) &&
           (after.command == "*" || sent == "*" || after.command == sent) &&
           std::ranges::any_of(before.to, [&](const std::string& sink) {
             return is_same(sink, after.source);
           });
  }

  static bool is_sure(const Route& route) {
    return route.condition == no_code && route.source != "*";
  }

  bool is_same(std::string sink, const std::string& source) const {
    if (sink.ends_with('*'))
      sink.pop_back();
    return canonical_role(sink) == canonical_role(source) ||
           fills(sink, source) || fills(source, sink);
  }

  bool fills(const std::string& component, const std::string& role) const {
    const auto found = subject_.options.component_roles.find(component);
    return found != subject_.options.component_roles.end() &&
           std::ranges::count(found->second, canonical_role(role)) > 0;
  }

  const Subject& subject_;
};

} // namespace

void lint_routes(const Subject& subject, Findings& findings) {
  const RouteLint lint(subject);
  for (const auto& route : subject.program.routes)
    if (const auto* last = lint.leads_back(route))
      warn(findings, "endless-relay", route.position,
           "what " + route.source + " sends is relayed " +
               (last == &route ? std::string("back to it")
                               : "in a ring, back by " + last->source) +
               ", which has no end if it answers in kind; set a condition "
               "with 'if', or relay less");
}

} // namespace parlour::script::lint
