// unknown-frame: a script hands over frames whose act, topic or slot does not
// exist. Only literal frames can be judged.
//
//   <fire param="{'act': 'inform', 'topic': 'Taxy'}"/>    no such topic
#include <algorithm>

#include "runtime/message/roles.hpp"
#include "script/lint/passes.hpp"

namespace parlour::script::lint {

namespace {

// The value for a key; null if the map does not have it.
const Node* entry(const Node& map, std::string_view key) {
  for (std::size_t i = 0; i < map.keys.size(); ++i)
    if (map.keys[i] == key)
      return map.children[i].get();
  return nullptr;
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
  return std::ranges::find(all, one) != all.end();
}

// A handler that reacts to acts of Dialogue may use names that no topic has.
bool is_reacted_to(const Program& program, const std::string& act) {
  const auto takes = [&](const auto& reactions) {
    return std::ranges::any_of(reactions, [&](const Reaction& one) {
      return (one.source == "Dialogue" || one.source == "*") &&
             (one.event == act || one.event == "*");
    });
  };
  return std::ranges::any_of(
             program.handlers,
             [&](const auto& one) { return takes(one.reactions); }) ||
         std::ranges::any_of(program.states, [&](const auto& one) {
           return takes(one.messages);
         });
}

// Examines the maps in one expression.
class FrameLint {
public:
  FrameLint(const LintContext& context, Position position, Findings& findings)
      : program_(context.program), position_(position), findings_(findings) {}

  void look_at(const Node& node);

private:
  void tell(const std::string& message, const std::string& name,
            const std::vector<std::string>& known) {
    warn(findings_, "unknown-frame", position_,
         message + " '" + name + "'" + did_you_mean(name, known));
  }
  void slots(const Topic& topic, const Node& map);

  const Program& program_;
  Position position_;
  Findings& findings_;
};

// The keys of `slots` must be slots of the topic.
void FrameLint::slots(const Topic& topic, const Node& map) {
  const auto known = names_in(topic.slots);
  for (const auto& name : map.keys)
    if (!contains(known, name))
      tell("the topic '" + topic.name + "' has no slot", name, known);
}

// A list of frames, or one frame. Computed acts and topics are skipped.
void FrameLint::look_at(const Node& node) {
  if (node.kind == NodeKind::list)
    for (const auto& child : node.children)
      look_at(*child);
  if (node.kind != NodeKind::map)
    return;
  const auto* act = entry(node, "act");
  const auto acts = names_in(find_role("Dialogue")->events);
  if (act && act->kind == NodeKind::string && !contains(acts, act->text))
    return tell("there is no act", act->text, acts);
  const auto* topic = entry(node, "topic");
  if (!topic || topic->kind != NodeKind::string ||
      (act && act->kind != NodeKind::string) ||
      is_reacted_to(program_, act ? act->text : "inform"))
    return;
  const auto id = program_.topic(topic->text);
  if (id == no_id)
    return tell("there is no topic", topic->text, names_in(program_.topics));
  if (const auto* map = entry(node, "slots"))
    slots(program_.topics[id], *map);
}

} // namespace

void lint_frames(const LintContext& context, Findings& findings) {
  if (!context.settings)
    return;
  walk(context, false, [&](const Element& element, const ElementRule& rule) {
    const auto* param =
        is_statement(rule) && element.is("fire") && !element.attribute("event")
            ? element.attribute("param")
            : nullptr;
    if (!param)
      return;
    if (const auto parsed = parse_expression(param->value); parsed.node)
      FrameLint(context, param->value_position, findings).look_at(*parsed.node);
  });
}

} // namespace parlour::script::lint
