#include "script/compiler/application/seats_reader.hpp"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/message/roles.hpp"

namespace parlour::script {

namespace {

// What a run calls the seats that it opens by itself (actors/node/node.cpp).
constexpr std::string_view name_of_others = "seat-";

std::vector<std::string> role_names() {
  std::vector<std::string> names;
  for (const auto& role : roles())
    if (!role.reserved)
      names.push_back(role.name);
  return names;
}

class SeatsReader {
public:
  SeatsReader(const std::function<std::string(const std::string&)>& own_name,
              Settings& settings, Findings& findings)
      : own_name_(own_name), settings_(settings), findings_(findings) {}

  void read(const Element& element) {
    SeatSettings seat{element.value("name")};
    seat.place = findings_.place(element.position);
    if (!check_name(element))
      return;
    if (const auto* after = element.attribute("closes-after"))
      if (const auto time = parse_duration(after->value))
        seat.closes_after = *time;
    for (const auto& attribute : element.attributes)
      if (attribute.name != "name" && attribute.name != "opens" &&
          attribute.name != "closes-after")
        bind(attribute, seat);
    settings_.seats.push_back(std::move(seat));
  }

private:
  bool check_name(const Element& element) {
    const auto* name = element.attribute("name");
    if (!name)
      return false; // the validator says so
    const auto [first, is_first] =
        lines_.emplace(name->value, element.position.line);
    std::string fault;
    if (name->value.empty())
      fault = "a seat needs a name";
    else if (name->value.starts_with(name_of_others))
      fault = "'" + name->value +
              "' is what a run calls a seat of its own; give this one a name "
              "that does not begin with 'seat-'";
    else if (!is_first)
      fault = "a second seat '" + name->value + "', after the one in line " +
              std::to_string(first->second) +
              "; put both into one, or give this one another name";
    if (!fault.empty())
      findings_.error(name->value_position, fault);
    return fault.empty();
  }

  // ROLE="component".
  void bind(const Attribute& attribute, SeatSettings& seat) {
    const auto* role = find_role(attribute.name);
    if (!role || role->reserved)
      return tell_no_role(attribute);
    const auto name = own_name_(attribute.value);
    if (!is_known(name))
      return tell_unknown(attribute);
    const auto [first, is_first] = seat_of_.emplace(name, seat.name);
    if (first->second != seat.name)
      return findings_.error(
          attribute.value_position,
          "'" + name + "' is at the seat '" + first->second +
              "' already, and a component is at one seat; a further instance "
              "of its plug-in has a name of its own: <component name=\"…\" "
              "plugin=\"…\"/>");
    if (is_first && !take_over(name, seat.name, attribute))
      return;
    seat.components.push_back(
        {role->name, name, findings_.place(attribute.value_position)});
  }

  void tell_no_role(const Attribute& attribute) {
    const auto hint = did_you_mean(attribute.name, role_names());
    findings_.error(attribute.position,
                    "<seat> has no attribute '" + attribute.name +
                        "', and no role has that name" +
                        (hint.empty() ? "; roles are listed by `parlour plugin "
                                        "roles`"
                                      : hint));
  }

  bool is_known(const std::string& name) const {
    return std::ranges::count(settings_.components, name,
                              &ComponentSettings::name) > 0 ||
           std::ranges::count(settings_.agents.agents, name,
                              &AgentSettings::name) > 0;
  }

  void tell_unknown(const Attribute& attribute) {
    std::vector<std::string> known;
    for (const auto& component : settings_.components)
      known.push_back(component.name);
    for (const auto& agent : settings_.agents.agents)
      known.push_back(agent.name);
    const auto hint = did_you_mean(attribute.value, known);
    findings_.error(
        attribute.value_position,
        "there is no component and no agent '" + attribute.value + "'" +
            (hint.empty() ? "; list it in <Plugins>, or say "
                            "<component name=\"" +
                                attribute.value + "\" plugin=\"…\"/>"
                          : hint));
  }

  // Its only instance is the seat's. An agent has no scope to change.
  bool take_over(const std::string& name, const std::string& seat,
                 const Attribute& attribute) {
    const auto component =
        std::ranges::find(settings_.components, name, &ComponentSettings::name);
    if (component == settings_.components.end())
      return true;
    auto& scope = component->policy.scope;
    if (scope.kind != Scope::Kind::usual && scope.kind != Scope::Kind::seat) {
      findings_.error(attribute.value_position,
                      "'" + name +
                          "' has another scope, and a component of a seat has "
                          "one instance, there; leave its scope=\"…\" out");
      return false;
    }
    scope.kind = Scope::Kind::seat;
    component->policy.seat = seat;
    return true;
  }

  const std::function<std::string(const std::string&)>& own_name_;
  Settings& settings_;
  Findings& findings_;
  std::map<std::string, std::uint32_t> lines_; // of the seats, by name
  std::map<std::string, std::string> seat_of_; // by component
};

} // namespace

void read_seats(const Element& root,
                const std::function<std::string(const std::string&)>& own_name,
                Settings& settings, Findings& findings) {
  SeatsReader reader(own_name, settings, findings);
  for (const auto& child : root.children)
    if (child.is("seat"))
      reader.read(child);
}

} // namespace parlour::script
