// unreachable-state, state-without-exit, and endless-loop for states whose
// entrances lead to each other.
//
// A <transit> with a computed name may lead anywhere; then no state counts as
// unreachable.
#include <map>

#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// Where statements lead.
struct Ways {
  std::set<std::string> targets; // of <transit> and <push>
  bool computed = false;         // one has a computed name
  bool leaves = false;           // a <pop> or <end>

  bool any() const {
    return computed || leaves || !targets.empty();
  }
};

// Adds the way that a statement opens, if any.
void add_way(const Element& element, Ways& ways) {
  if (element.is("pop") || element.is("end"))
    ways.leaves = true;
  if (!element.is("transit") && !element.is("push"))
    return;
  const auto target = element.value("state");
  if (is_computed(target))
    ways.computed = true;
  else
    ways.targets.insert(target);
}

// The ways out of each state, and those of everything outside of states, which
// are open in every state.
struct Map {
  std::map<std::string, Ways> of_state;
  std::map<std::string, const Element*> elements;
  Ways elsewhere;
  bool computed = false;

  void add(const Element& root, const ElementRule& rule);
};

// Sorts all statements by the state that they belong to.
void Map::add(const Element& root, const ElementRule& rule) {
  for (const auto& child : root.children) {
    const auto* inside = find_rule(child.name, rule.holds);
    if (!inside)
      continue;
    const bool is_state = child.is("state");
    auto& ways = is_state ? of_state[child.value("name")] : elsewhere;
    walk(child, *inside, [&](const Element& element, const ElementRule& its) {
      if (is_statement(its))
        add_way(element, ways);
    });
    computed |= ways.computed;
    if (is_state)
      elements[child.value("name")] = &child;
  }
}

Map map_of(const LintContext& context) {
  Map map;
  for (const auto& document : context.documents)
    if (!document.platform) // its goodbye is not a state's way out
      map.add(document.root, rule_of(document.root));
  if (context.settings)
    map.add(*context.settings, rule_of(*context.settings));
  return map;
}

// Adds all states that can be reached from this one.
void reach(const std::string& state, const Map& map,
           std::set<std::string>& reached) {
  std::vector<std::string> waiting{state};
  while (!waiting.empty()) {
    const auto found = map.of_state.find(waiting.back());
    waiting.pop_back();
    if (found == map.of_state.end() || !reached.insert(found->first).second)
      continue;
    const auto& targets = found->second.targets;
    waiting.insert(waiting.end(), targets.begin(), targets.end());
  }
}

// A state is reachable from the start, or from anywhere by what stands outside.
void lint_reachable(const LintContext& context, const Map& map,
                    Findings& findings) {
  if (!context.settings || map.computed)
    return;
  std::set<std::string> reached;
  reach(context.program.settings.start, map, reached);
  for (const auto& target : map.elsewhere.targets)
    reach(target, map, reached);
  for (const auto& [name, element] : map.elements)
    if (!reached.count(name))
      warn(findings, "unreachable-state", element->position,
           "nothing leads to the state '" + name +
               "'; enter it by <transit state=\"" + name +
               "\"/> or by 'start' of the settings, or take it out");
}

// Only if nothing outside of the states leads anywhere.
void lint_exits(const LintContext& context, const Map& map,
                Findings& findings) {
  if (!context.settings || map.elements.size() < 2 || map.elsewhere.any())
    return;
  for (const auto& [name, element] : map.elements)
    if (!map.of_state.at(name).any() && !element->children.empty())
      warn(findings, "state-without-exit", element->position,
           "nothing leaves the state '" + name +
               "'; a conversation that is over ends with <end/>, others go on "
               "by <transit>");
}

// The state to which an entrance goes unconditionally; empty if there is none.
std::string certain_target(const Element& state) {
  const auto* entrance = state.child("Entrance");
  if (entrance)
    for (const auto& statement : entrance->children)
      if (statement.is("transit"))
        return statement.value("state");
  return {};
}

// Follows certain targets from each state. A state met twice on the same way
// closes a circle; states of earlier ways are not followed again.
void lint_circles(const Map& map, Findings& findings) {
  std::set<std::string> done;
  for (const auto& [name, element] : map.elements) {
    std::set<std::string> seen;
    auto at = name;
    while (map.elements.count(at) && !done.count(at) && seen.insert(at).second)
      at = certain_target(*map.elements.at(at));
    if (seen.count(at))
      warn(findings, "endless-loop", map.elements.at(at)->position,
           "the entrance of the state '" + at +
               "' leads back to itself at once; let an event or a condition "
               "decide about the <transit>");
    done.insert(seen.begin(), seen.end());
  }
}

} // namespace

// The three checks share one map of ways.
void lint_states(const LintContext& context, Findings& findings) {
  const auto map = map_of(context);
  lint_reachable(context, map, findings);
  lint_exits(context, map, findings);
  lint_circles(map, findings);
}

} // namespace parlour::script::lint
