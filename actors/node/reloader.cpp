#include "actors/node/reloader.hpp"

#include <algorithm>
#include <utility>

#include <malloc.h>

namespace parlour::actors {

namespace {

bool runs(const ComponentOrder& order) {
  return order.policy.scope.instances != 0;
}

// Null where there is none of that name.
const ComponentOrder* find_order(const std::vector<ComponentOrder>& all,
                                 const std::string& name) {
  const auto found = std::ranges::find(all, name, &ComponentOrder::name);
  return found == all.end() ? nullptr : &*found;
}

// What the application took before lies between what conversations have. The
// allocator keeps such pieces, and a server that is reloaded often would seem
// to grow. Takes some milliseconds.
void give_memory_back() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace

int phase_of_start(const ComponentOrder& order) {
  const auto& roles = order.factory.description.roles;
  if (std::ranges::find(roles, "Database") != roles.end())
    return 0;
  return order.policy.scope.kind == Scope::Kind::seat ? 2 : 1;
}

Reloader::Reloader(Parts parts, ChangedApplication first)
    : parts_(std::move(parts)), current_(std::move(first)) {}

// Whether anything is hidden is decided when a node starts: what nobody hides
// from watchers is shown to them at once (Observer).
Expected<ReloadOutcome> Reloader::reload(ChangedApplication to,
                                         ReloadMode mode) {
  const std::lock_guard lock(mutex_);
  if (!parts_.bus.observer().discretion().hides() &&
      script::has_private(*to.program))
    return fail(ErrorKind::refused,
                "the changed scripts have private values, which this run does "
                "not hide from who watches it: start it again");
  const auto before = parts_.environment.now();
  auto environment = *before;
  environment.phrases = to.phrases;
  environment.understanding =
      to.understanding ? to.understanding : to.program->understanding;
  environment.columns = to.columns;
  const auto readers = change_environment(
      std::make_shared<const PluginEnvironment>(std::move(environment)));
  if (!readers)
    return tl::make_unexpected(readers.error());
  ReloadOutcome outcome;
  if (auto loaded = load_changed(to, *readers, outcome.loaded); !loaded) {
    take_back(before, outcome.loaded);
    return tl::make_unexpected(std::move(loaded.error()));
  }
  for (const auto& one : current_.components)
    if (!find_order(to.components, one.name) &&
        order(unload_component{one.name, parts_.time.work.begin()}))
      outcome.unloaded.push_back(one.name);
  parts_.bus.set_program(to.program);
  const auto reloaded = parts_.questions.ask<program_reloaded>(
      parts_.manager,
      reload_program{to.program, to.phrases, mode, parts_.time.work.begin()});
  if (reloaded)
    outcome.sessions = reloaded->sessions;
  current_ = std::move(to);
  give_memory_back();
  return outcome;
}

Expected<Reloader::Readers>
Reloader::change_environment(SharedEnvironment::Pointer to) {
  return parts_.questions
      .ask<environment_changed>(
          parts_.supervisor,
          actors::change_environment{std::move(to), parts_.time.work.begin()})
      .map([](environment_changed changed) {
        return std::move(changed.readers);
      });
}

// -- components ---------------------------------------------------------------

Expected<void> Reloader::load(const ComponentOrder& order,
                              std::vector<std::string>& loaded) {
  auto done =
      this->order(load_component{std::make_shared<const ComponentOrder>(order),
                                 0, parts_.time.work.begin()});
  if (done && runs(order))
    loaded.push_back(order.name);
  return done;
}

// Those of the settings that are new or others than before, or that know the
// scripts; then what scripts have loaded and knows them. Databases first, as
// others read from them when they start.
Expected<void> Reloader::load_changed(const ChangedApplication& to,
                                      const Readers& readers,
                                      std::vector<std::string>& loaded) {
  auto changed = to.components;
  std::erase_if(changed, [&](const ComponentOrder& one) {
    const auto* before = find_order(current_.components, one.name);
    return before && before->same_as(one) && !readers.contains(one.name);
  });
  std::ranges::stable_sort(changed, {}, phase_of_start);
  for (const auto& one : changed)
    if (auto done = load(one, loaded); !done)
      return done;
  for (const auto& [name, plugin] : readers) {
    const auto* of_settings = find_order(to.components, name);
    if (of_settings && runs(*of_settings))
      continue;
    if (auto done = order(load_plugin{plugin, name, parts_.time.work.begin()});
        !done)
      return done;
    loaded.push_back(name);
  }
  return {};
}

// They have worked before, so that no error is expected; one is logged by the
// supervisor.
void Reloader::take_back(const SharedEnvironment::Pointer& environment,
                         const std::vector<std::string>& loaded) {
  const auto readers = change_environment(environment).value_or(Readers());
  std::vector<std::string> again;
  for (const auto& name : loaded) {
    const auto* before = find_order(current_.components, name);
    if (before && runs(*before))
      static_cast<void>(load(*before, again));
    else if (const auto reader = readers.find(name); reader != readers.end())
      static_cast<void>(
          order(load_plugin{reader->second, name, parts_.time.work.begin()}));
    else
      static_cast<void>(
          order(unload_component{name, parts_.time.work.begin()}));
  }
}

} // namespace parlour::actors
