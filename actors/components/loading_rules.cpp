#include "actors/components/loading_rules.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/plugin/component_check.hpp"
#include "runtime/plugin/scope_check.hpp"
#include "script/source/findings.hpp"

namespace parlour::actors {

namespace {

tl::unexpected<Error> wrong(const ComponentOrder& order,
                            const std::string& what) {
  return fail(ErrorKind::settings, order.name + ": " + what);
}

} // namespace

// Without the function that makes the plug-in: the catalogue gives one when it
// is loaded again.
void LoadingRules::remember(const ComponentOrder& order) {
  auto& known = known_[order.name];
  known = order;
  known.factory.create = nullptr;
}

// What is known counts only if it is about the same plug-in: another one under
// this name has other options. `<load>` starts at least one, also where the
// settings say 0 (which means: not at the start).
Expected<ComponentOrder>
LoadingRules::order_for(const std::string& plugin,
                        const std::string& name) const {
  if (!settings_.plugins)
    return fail(ErrorKind::refused, "this run has no plug-ins to load");
  ComponentOrder order;
  order.name = name.empty() ? plugin : name;
  auto factory = settings_.plugins->find(plugin);
  if (!factory)
    return tl::make_unexpected(factory.error());
  order.factory = std::move(*factory);
  const auto known = known_.find(order.name);
  if (known != known_.end() &&
      known->second.factory.description.name == plugin) {
    order.options = known->second.options;
    order.policy = known->second.policy;
    auto& instances = order.policy.scope.instances;
    instances = std::max<std::size_t>(instances, 1);
  }
  if (settings_.complete)
    settings_.complete(order);
  return order;
}

// A second load of a name that is still coming is refused, as both would take
// over the same mailbox. One that replaces has to fill all roles of the one
// before (engine rule 1.5).
Expected<void> LoadingRules::check(const ComponentOrder& order) const {
  const auto& plugin = order.factory.description;
  if (deployments_.coming.count(order.name) != 0)
    return wrong(order, "is being loaded already");
  if (auto right = check_component(order.name, plugin); !right)
    return right;
  if (const auto before = deployments_.find(order.name))
    if (auto may = check_replacement(order.name,
                                     before->order.factory.description, plugin);
        !may)
      return may;
  if (auto fits = check_scope(order.policy.scope, plugin); !fits)
    return wrong(order, fits.error().message);
  return check_options(order);
}

Expected<void> LoadingRules::check_options(const ComponentOrder& order) const {
  for (const auto& option : order.factory.description.options)
    if (option.required && order.options.count(option.name) == 0)
      return wrong(order, "the option '" + option.name +
                              "' is missing: " + option.sentence);
  return {};
}

Error LoadingRules::nobody_called(const std::string& name) const {
  std::vector<std::string> names;
  for (const auto& [known, deployment] : deployments_.serving)
    names.push_back(known);
  return {ErrorKind::offline,
          "there is no component '" + name + "'" +
              script::did_you_mean(name, names),
          {}};
}

} // namespace parlour::actors
