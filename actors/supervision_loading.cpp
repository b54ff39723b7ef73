// The part of supervision that says how components come and go.
#include <algorithm>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/supervision.hpp"
#include "actors/supervisor.hpp"
#include "runtime/plugin/scope_check.hpp"
#include "script/findings.hpp"

namespace parlour::actors {

namespace {

// What departs has this long for what it has begun.
constexpr Milliseconds drain_time{2'000};

} // namespace

// -- what is wished -----------------------------------------------------------

void Supervision::load(const load_component& what) {
  if (auto may = may_come(*what.order); !may)
    return what.done(may);
  settled_[what.order->name] = *what.order;
  settled_[what.order->name].factory.create = nullptr;
  come(*what.order, what.rank, false, what.done);
}

void Supervision::load(const load_plugin& what) {
  auto order = order_for(what);
  if (!order)
    return what.done(tl::make_unexpected(order.error()));
  if (auto may = may_come(*order); !may)
    return what.done(may);
  come(*order, 0, true, what.done);
}

void Supervision::unload(const unload_component& what) {
  const auto found = kept_.find(what.name);
  if (found != kept_.end())
    return depart(found->second, true, what.done);
  std::vector<std::string> names;
  for (const auto& [name, kept] : kept_)
    names.push_back(name);
  what.done(
      fail(ErrorKind::offline, "there is no component '" + what.name + "'" +
                                   script::did_you_mean(what.name, names)));
}

void Supervision::stop_all() {
  closing_ = true;
  for (auto& [name, kept] : kept_)
    kept->component->mailbox->close("stops");
  for (auto& [id, entry] : entries_)
    if (entry.stage != Stage::stops)
      stop(entry);
  for (auto& [name, kept] : kept_)
    kept->component->mailbox->take_all();
}

// -- coming -------------------------------------------------------------------

// What settings say of a component of this name counts here, too.
Expected<ComponentOrder> Supervision::order_for(const load_plugin& what) const {
  if (!services_.plugins)
    return fail(ErrorKind::refused, "this run has no plug-ins to load");
  ComponentOrder order;
  order.name = what.name.empty() ? what.plugin : what.name;
  auto factory = services_.plugins->find(what.plugin);
  if (!factory)
    return tl::make_unexpected(factory.error());
  order.factory = std::move(*factory);
  const auto known = settled_.find(order.name);
  if (known != settled_.end() &&
      known->second.factory.description.name == what.plugin) {
    order.options = known->second.options;
    order.upkeep = known->second.upkeep;
  }
  return order;
}

Expected<void> Supervision::may_come(const ComponentOrder& order) const {
  const auto& plugin = order.factory.description;
  auto wrong = [&](const std::string& what) {
    return fail(ErrorKind::settings, order.name + ": " + what);
  };
  if (closing_)
    return fail(ErrorKind::cancelled, "the application stops");
  if (coming_.count(order.name) != 0)
    return wrong("is being loaded already");
  if (auto fits = check_scope(order.upkeep.scope, plugin); !fits)
    return wrong(fits.error().message);
  for (const auto& option : plugin.options)
    if (option.required && order.options.count(option.name) == 0)
      return wrong("the option '" + option.name +
                   "' is missing: " + option.sentence);
  return {};
}

void Supervision::come(const ComponentOrder& order, std::size_t rank, bool tell,
                       Done done) {
  auto kept = std::make_shared<Kept>();
  kept->component = std::make_shared<Component>();
  kept->component->order = order;
  const auto before = kept_.find(order.name);
  kept->component->mailbox = before == kept_.end()
                                 ? std::make_shared<ComponentMailbox>()
                                 : before->second->component->mailbox;
  kept->rank = rank;
  kept->tell = tell;
  kept->done = std::move(done);
  coming_[order.name] = kept;
  make_missing(kept);
}

// One of its instances works: once all do, it takes its place.
void Supervision::came(const KeptPointer& kept) {
  const auto ids = instances_of(kept);
  const auto& component = *kept->component;
  if (!std::all_of(ids.begin(), ids.end(),
                   [&](auto id) { return entries_[id].stage == Stage::works; }))
    return;
  coming_.erase(component.name());
  auto& place = kept_[component.name()];
  if (place)
    kept->rank = place->rank;
  else if (kept->rank == 0)
    kept->rank = last_rank_ + 1;
  last_rank_ = std::max(last_rank_, kept->rank);
  const auto before = std::exchange(place, kept);
  *component.up = true;
  publish_table();
  if (before)
    depart(before, false, {});
  component.mailbox->open();
  for (auto id : ids)
    component.mailbox->join(entries_[id].host);
  if (kept->tell)
    tell_up(component);
  std::exchange(kept->done, {})({});
}

// What was there before stays.
void Supervision::came_not(const KeptPointer& kept, Error error) {
  coming_.erase(kept->component->name());
  for (auto id : instances_of(kept))
    if (auto& entry = entries_[id]; entry.stage != Stage::stops)
      stop(entry);
  if (auto done = std::exchange(kept->done, {}))
    done(tl::make_unexpected(std::move(error)));
}

// -- departing ----------------------------------------------------------------

// By value: who calls may hold it in what is erased here.
void Supervision::depart(KeptPointer kept, bool unloads, Done done) {
  const auto id = ++last_number_;
  departures_[id] = {kept, unloads, std::move(done), ticket(drain_time)};
  if (unloads) {
    kept->component->mailbox->close("is being unloaded");
    kept_.erase(kept->component->name());
    publish_table();
  }
  for (auto instance : instances_of(kept)) {
    auto& entry = entries_[instance];
    if (!unloads)
      kept->component->mailbox->leave(entry.host);
    entry.instance->leaves = true;
    entry.instance->door->leaves();
  }
  self_->delayed_send(self_, drain_time, actors::drain_over{id});
  see_off(id, false);
}

std::uint64_t Supervision::departure_of(const KeptPointer& kept) const {
  for (const auto& [id, departure] : departures_)
    if (departure.kept == kept)
      return id;
  return 0;
}

bool Supervision::has_finished(const Entry& entry,
                               const Departure& departure) const {
  return !entry.instance->watch.in_call() &&
         entry.instance->door->owes_nothing() &&
         (!departure.unloads || entry.kept->component->mailbox->empty());
}

void Supervision::see_off(std::uint64_t id, bool at_once) {
  const auto& departure = departures_[id];
  for (auto instance : instances_of(departure.kept)) {
    auto& entry = entries_[instance];
    if (entry.stage != Stage::stops &&
        (at_once || has_finished(entry, departure)))
      stop(entry);
  }
  gone(id);
}

void Supervision::rests(const instance_rests& what) {
  const auto found = entries_.find(what.instance);
  if (found == entries_.end())
    return;
  if (const auto id = departure_of(found->second.kept); id != 0)
    see_off(id, false);
}

void Supervision::drain_over(const actors::drain_over& what) {
  const auto found = departures_.find(what.departure);
  if (found == departures_.end())
    return;
  found->second.due = {};
  see_off(what.departure, true);
}

// Once no instance is left.
void Supervision::gone(std::uint64_t id) {
  const auto found = departures_.find(id);
  if (found == departures_.end() || !instances_of(found->second.kept).empty())
    return;
  auto departure = std::move(found->second);
  departures_.erase(found);
  if (departure.unloads) {
    answer_what_waits(departure.kept, "it was unloaded");
    tell("ComponentDown", {departure.kept->component->name(), "unloaded"});
  }
  if (departure.done)
    departure.done({});
}

// -- the table ----------------------------------------------------------------

void Supervision::publish_table() {
  std::vector<KeptPointer> order;
  for (const auto& [name, kept] : kept_)
    order.push_back(kept);
  std::ranges::sort(order, {}, &Kept::rank);
  auto parts = services_.routing;
  for (const auto& kept : order) {
    const auto& component = *kept->component;
    parts.targets.push_back({component.name(), component.description().roles,
                             component.mailbox, kept->direct, component.up});
  }
  services_.table.store(std::make_shared<const RoutingTable>(std::move(parts)));
}

} // namespace parlour::actors
