// The part of supervision that says how components come and go.
#include <algorithm>
#include <utility>

#include <caf/typed_event_based_actor.hpp>

#include "actors/components/supervision.hpp"
#include "actors/components/supervisor.hpp"
#include "runtime/base/call_deadline.hpp"
#include "runtime/plugin/component_check.hpp"
#include "runtime/plugin/scope_check.hpp"
#include "script/source/findings.hpp"

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
  if (what.order->upkeep.scope.instances == 0) // for <load> alone
    return what.done({});
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
  if (const auto found = kept_.extract(what.name)) {
    publish_table();
    return depart(branches_of(*found.mapped()), what.name, what.done);
  }
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
    for (auto& [place, branch] : kept->branches)
      branch->component->mailbox->close("stops");
  for (auto& [id, entry] : entries_)
    if (entry.stage != Stage::stops)
      stop(entry);
  for (auto& [name, kept] : kept_)
    for (auto& [place, branch] : kept->branches)
      branch->component->mailbox->take_all();
}

// -- coming -------------------------------------------------------------------

// What settings say of a component of this name counts here, too.
Expected<ComponentOrder> Supervision::order_for(const load_plugin& what) const {
  if (!parts_.settings.plugins)
    return fail(ErrorKind::refused, "this run has no plug-ins to load");
  ComponentOrder order;
  order.name = what.name.empty() ? what.plugin : what.name;
  auto factory = parts_.settings.plugins->find(what.plugin);
  if (!factory)
    return tl::make_unexpected(factory.error());
  order.factory = std::move(*factory);
  const auto known = settled_.find(order.name);
  if (known != settled_.end() &&
      known->second.factory.description.name == what.plugin) {
    order.options = known->second.options;
    order.upkeep = known->second.upkeep;
    auto& instances = order.upkeep.scope.instances;
    instances = std::max<std::size_t>(instances, 1);
  }
  if (parts_.settings.complete)
    parts_.settings.complete(order);
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
  if (auto right = check_component(order.name, plugin); !right)
    return right;
  if (const auto before = kept_.find(order.name); before != kept_.end())
    if (auto may = check_replacement(
            order.name, before->second->order.factory.description, plugin);
        !may)
      return may;
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
  using enum Scope::Kind;
  auto kept = std::make_shared<Kept>();
  kept->order = order;
  auto& upkeep = kept->order.upkeep;
  upkeep.deadline = call_deadline(upkeep, parts_.settings.request_timeout);
  kept->rank = rank;
  kept->tell = tell;
  kept->done = std::move(done);
  if (const auto scope = upkeep.scope.kind; scope == seat || scope == session)
    kept->by_session = std::make_shared<Branches>();
  coming_[order.name] = kept;
  settle(kept);
  came(kept); // if there is nobody yet to have a branch
}

// One of its instances works, or is not wanted any more: once all that are
// left work, it takes its place.
void Supervision::came(const KeptPointer& kept) {
  for (const auto& [place, branch] : kept->branches)
    for (auto id : instances_of(*branch))
      if (entries_[id].stage != Stage::works)
        return;
  coming_.erase(kept->order.name);
  takes_place(kept);
  settle(kept); // who came meanwhile
  if (kept->tell)
    for (const auto& branch : branches_of(*kept))
      tell_up(*branch->component, branch->place->session());
  std::exchange(kept->done, {})({});
}

void Supervision::takes_place(const KeptPointer& kept) {
  auto& place = kept_[kept->order.name];
  if (place)
    kept->rank = place->rank;
  else if (kept->rank == 0)
    kept->rank = last_rank_ + 1;
  last_rank_ = std::max(last_rank_, kept->rank);
  const auto before = std::exchange(place, kept);
  for (const auto& [name, branch] : kept->branches)
    *branch->component->up = true;
  publish_table();
  std::map<std::string, BranchPointer> leaving;
  if (before)
    leaving = before->branches;
  for (const auto& [name, branch] : kept->branches) {
    branch->component->mailbox->open();
    const auto old = leaving.find(name);
    if (old == leaving.end()) {
      begin(instances_of(*branch));
      continue;
    }
    old->second->handed_on = true; // mailbox_at
    old->second->successors = instances_of(*branch);
  }
  if (before)
    depart(branches_of(*before), {}, {});
}

void Supervision::begin(const std::vector<InstanceId>& instances) {
  for (auto id : instances)
    if (const auto found = entries_.find(id);
        found != entries_.end() && found->second.stage == Stage::works)
      found->second.branch->component->mailbox->join(found->second.host);
}

// What was there before stays.
void Supervision::came_not(const KeptPointer& kept, Error error) {
  coming_.erase(kept->order.name);
  for (const auto& [place, branch] : kept->branches)
    for (auto id : instances_of(*branch))
      if (auto& entry = entries_[id]; entry.stage != Stage::stops)
        stop(entry);
  if (auto done = std::exchange(kept->done, {}))
    done(tl::make_unexpected(std::move(error)));
}

// -- departing ----------------------------------------------------------------

std::vector<Supervision::BranchPointer>
Supervision::branches_of(const Kept& kept) {
  std::vector<BranchPointer> all;
  for (const auto& [place, branch] : kept.branches)
    all.push_back(branch);
  return all;
}

void Supervision::depart(std::vector<BranchPointer> branches,
                         const std::string& unloads, Done done) {
  const auto id = ++last_number_;
  for (const auto& branch : branches)
    withdraw(*branch);
  departures_[id] = {std::move(branches), unloads, std::move(done),
                     ticket(drain_time)};
  self_->delayed_send(self_, drain_time, actors::drain_over{id});
  see_off(id, false);
}

void Supervision::withdraw(Branch& branch) {
  auto& mailbox = *branch.component->mailbox;
  if (!branch.handed_on)
    mailbox.close("is being unloaded");
  for (auto instance : instances_of(branch)) {
    auto& entry = entries_[instance];
    if (branch.handed_on)
      mailbox.leave(entry.host);
    entry.instance->leaves = true;
    entry.instance->door->leaves();
  }
}

std::uint64_t Supervision::departure_of(const BranchPointer& branch) const {
  for (const auto& [id, departure] : departures_)
    if (std::ranges::count(departure.branches, branch) != 0)
      return id;
  return 0;
}

bool Supervision::has_finished(const Entry& entry) const {
  return !entry.instance->watch.in_call() &&
         entry.instance->door->owes_nothing() &&
         (entry.branch->handed_on || entry.branch->component->mailbox->empty());
}

void Supervision::see_off(std::uint64_t id, bool at_once) {
  for (const auto& branch : departures_[id].branches)
    for (auto instance : instances_of(*branch)) {
      auto& entry = entries_[instance];
      if (entry.stage != Stage::stops && (at_once || has_finished(entry)))
        stop(entry);
    }
  gone(id);
}

void Supervision::rests(const instance_rests& what) {
  const auto found = entries_.find(what.instance);
  if (found == entries_.end())
    return;
  if (const auto id = departure_of(found->second.branch); id != 0)
    see_off(id, false);
}

void Supervision::drain_over(const actors::drain_over& what) {
  const auto found = departures_.find(what.departure);
  if (found == departures_.end())
    return;
  found->second.due = {};
  see_off(what.departure, true);
}

// Once no instance is left; once all of a branch stop, others have its place.
void Supervision::gone(std::uint64_t id) {
  const auto found = departures_.find(id);
  if (found == departures_.end())
    return;
  bool is_gone = true;
  for (const auto& branch : found->second.branches) {
    const auto left = instances_of(*branch);
    is_gone = is_gone && left.empty();
    if (std::ranges::all_of(left, [&](auto instance) {
          return entries_[instance].stage == Stage::stops;
        }))
      begin(std::exchange(branch->successors, {}));
  }
  if (!is_gone)
    return;
  auto departure = std::move(found->second);
  departures_.erase(found);
  for (const auto& branch : departure.branches)
    if (!branch->handed_on)
      answer_what_waits(*branch, branch->over ? "its session is over"
                                              : "it was unloaded");
  if (!departure.unloads.empty())
    tell("ComponentDown", {departure.unloads, "unloaded"});
  if (departure.done)
    departure.done({});
}

} // namespace parlour::actors
