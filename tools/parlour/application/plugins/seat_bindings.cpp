#include "tools/parlour/application/plugins/seat_bindings.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace parlour::tools {

namespace {

using script::Severity;

std::string no_filler(const SeatSettings& seat,
                      const SeatSettings::Binding& binding,
                      const ChosenComponent& component,
                      const Composition& composition) {
  std::vector<std::string> able;
  for (const auto& one : composition.components)
    if (fills(one, binding.role))
      able.push_back(one.name);
  const auto& roles = component.factory.description.roles;
  return fmt::format(
      "'{}' does not fill the role {} at the seat '{}', but {}; {}",
      binding.component, binding.role, seat.name,
      roles.empty() ? "none" : fmt::format("{}", fmt::join(roles, ", ")),
      able.empty() ? "no component of the settings fills that role"
                   : fmt::format("it is filled by {}", fmt::join(able, ", ")));
}

} // namespace

// A component of the settings knows its seat already, and one that the command
// line puts in its place may have another (voice.cpp); an agent has no
// <component> in which that could stand.
void bind_to_seats(const Settings& settings, Composition& composition) {
  auto& components = composition.components;
  for (const auto& seat : settings.seats)
    for (const auto& binding : seat.components) {
      const auto found = std::ranges::find(components, binding.component,
                                           &ChosenComponent::name);
      if (found == components.end())
        continue; // its plug-in is not there, which is told
      if (found->policy.seat.empty()) {
        found->policy.scope.kind = Scope::Kind::seat;
        found->policy.seat = seat.name;
      }
      if (!fills(*found, binding.role))
        composition.findings.push_back(
            {Severity::error, binding.place,
             no_filler(seat, binding, *found, composition)});
    }
  std::stable_partition(
      components.begin(), components.end(),
      [](const ChosenComponent& one) { return !one.policy.seat.empty(); });
}

} // namespace parlour::tools
