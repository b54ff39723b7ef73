#include "actors/node/node_runtime.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>
#include <utility>

#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/components/instance/component_host.hpp"
#include "actors/components/supervisor.hpp"
#include "actors/node/metrics_collector.hpp"
#include "actors/node/reloader.hpp"
#include "actors/routing/message_centre.hpp"
#include "actors/sessions/file_keeper.hpp"
#include "actors/sessions/session.hpp"
#include "actors/sessions/session_manager.hpp"

namespace parlour::actors {

namespace {

// When the node stops nobody should have to wait long to hear who is at work.
constexpr Milliseconds patience_at_end{200};

std::unique_ptr<Scheduler> make_scheduler(const NodeOptions& options) {
  return options.virtual_start
             ? make_virtual_time(*options.virtual_start)
             : make_real_time(options.threads, options.real_start);
}

template <class Actor>
void add(std::vector<ActorHandle>& all, const char* kind,
         const std::string& name, const Actor& actor) {
  all.push_back({kind, name, caf::actor_cast<caf::strong_actor_ptr>(actor)});
}

PluginEnvironment plugin_environment(const NodeOptions& options) {
  return {options.phrases,
          options.understanding ? options.understanding
                                : options.program->understanding,
          options.columns, options.data_folder, options.application_folder};
}

} // namespace

NodeRuntime::NodeRuntime(NodeOptions options)
    : options_(std::move(options)), scheduler_(make_scheduler(options_)),
      ids_(options_.seed), time_(scheduler_->clock(), scheduler_->queue_kind()),
      observer_(watcher(), time_.left_behind),
      plugin_environment_(plugin_environment(options_)),
      bus_(time_, observer_, options_.program, options_.aliases) {
  scheduler_->configure(config_);
  system_ = std::make_unique<caf::actor_system>(config_);
  scheduler_->attach(*system_, time_);
  spawn_actors();
  reloader_ = std::make_unique<Reloader>(
      Reloader::Parts{questions(), time_, bus_, plugin_environment_,
                      supervisor_, manager_},
      ChangedApplication{options_.program, options_.components,
                         options_.phrases, options_.understanding,
                         options_.columns});
}

NodeRuntime::~NodeRuntime() {
  [[maybe_unused]] const bool down = stop();
  assert(down);
}

// -- bringing up --------------------------------------------------------------

Observer::Watcher NodeRuntime::watcher() {
  Observer::Watcher watcher;
  watcher.on_inspection = options_.on_inspection;
  watcher.all = options_.inspect_all;
  watcher.exact = options_.exact_inspections;
  watcher.actors = options_.trace_actors;
  watcher.on_log = options_.log;
  if (script::has_private(*options_.program))
    watcher.is_heard = [this](const Message& message) {
      return bus_.is_heard(message);
    };
  return watcher;
}

// Each is given handles of those spawned before it; the bus learns of the
// centre last, as it routes for all of them.
void NodeRuntime::spawn_actors() {
  supervisor_ = system_->spawn(supervisor, supervision_parts());
  const ActorTrace file_keeper_trace(observer_, file_keeper_state::name, "");
  file_keeper_ =
      scheduler_->detaches()
          ? system_->spawn<caf::detached>(file_keeper, options_.files,
                                          file_keeper_trace)
          : system_->spawn(file_keeper, options_.files, file_keeper_trace);
  const SessionNames names{[this] { return ids_.session_id(); },
                           [this] { return ids_.session_seed(); }};
  manager_ =
      system_->spawn(session_manager, session_parts(), &sessions_, names);
  centre_ = system_->spawn(message_centre, &bus_, &sessions_, manager_);
  bus_.connect(centre_);
}

SupervisionParts NodeRuntime::supervision_parts() {
  ComponentSettings settings;
  settings.plugins = options_.plugins;
  settings.complete = options_.complete;
  settings.start_time = options_.start_time;
  settings.request_timeout =
      options_.program->settings.sessions.request_timeout;
  settings.detaches = scheduler_->detaches();
  return {time_,   bus_, observer_, sessions_, instances_, plugin_environment_,
          settings};
}

SessionParts NodeRuntime::session_parts() {
  SessionParts parts{time_, bus_, observer_, options_.program};
  parts.phrases = options_.phrases;
  parts.sockets = options_.sockets;
  parts.journal = options_.journal;
  parts.strict_journal = options_.journal && options_.strict_journal;
  parts.supervisor = supervisor_;
  parts.file_keeper = file_keeper_;
  if (options_.restores_after_each_input)
    parts.after_input = [](SessionDialogue& dialogue, Timestamp now) {
      auto renewed = dialogue.renew(now);
      dialogue.rest_if_idle(Milliseconds::zero(), now);
      return renewed;
    };
  return parts;
}

Expected<void> NodeRuntime::start_components() {
  for (const auto rank : in_starting_order()) {
    const auto name = options_.components[rank].name + ": ";
    if (auto started = start(rank); !started) {
      auto error = started.error();
      if (!error.message.starts_with(name))
        error.message = name + error.message;
      stop();
      return tl::make_unexpected(std::move(error));
    }
  }
  return {};
}

std::vector<std::size_t> NodeRuntime::in_starting_order() const {
  std::vector<std::size_t> order(options_.components.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [this](std::size_t rank) {
    return phase_of_start(options_.components[rank]);
  });
  return order;
}

Expected<void> NodeRuntime::start(std::size_t rank) {
  return questions().order(
      supervisor_, load_component{std::make_shared<const ComponentOrder>(
                                      std::move(options_.components[rank])),
                                  rank + 1, time_.work.begin()});
}

Expected<void> NodeRuntime::load(const std::string& plugin,
                                 const std::string& name) {
  return questions().order(supervisor_,
                           load_plugin{plugin, name, time_.work.begin()});
}

Expected<void> NodeRuntime::unload(const std::string& name) {
  return questions().order(supervisor_,
                           unload_component{name, time_.work.begin()});
}

// -- sessions -----------------------------------------------------------------

seat_actor NodeRuntime::open_seat(const std::string& name, SeatCalls calls) {
  auto opened = system_->spawn(
      seat, SeatParts{&time_, &observer_, &sessions_, name}, std::move(calls));
  {
    std::lock_guard lock(seats_mutex_);
    seats_.emplace(name, opened);
  }
  caf::anon_send(manager_, seat_opened{name, opened, time_.work.begin()});
  caf::anon_send(supervisor_, seat_opened{name, opened, time_.work.begin()});
  return opened;
}

SessionId
NodeRuntime::open_session(const seat_actor& seat,
                          std::shared_ptr<const dialogue::SavedSession> saved) {
  const auto opened = questions().ask<session_opened>(
      manager_,
      actors::open_session{seat, time_.work.begin(), std::move(saved)});
  if (!opened)
    return {};
  // It answers when it has begun, as the manager has told it to before. Others
  // may be busy for long.
  if (scheduler_->detaches())
    static_cast<void>(state_of(opened->session));
  return opened->session;
}

void NodeRuntime::begin_visit(
    const std::string& name, SeatCalls calls,
    std::shared_ptr<const dialogue::SavedSession> saved) {
  auto shared = std::make_shared<const SeatCalls>(std::move(calls));
  std::lock_guard lock(seats_mutex_);
  if (manager_)
    caf::anon_send(manager_,
                   actors::begin_visit{name, std::move(shared),
                                       std::move(saved), time_.work.begin()});
}

void NodeRuntime::end_visit(const std::string& name) {
  std::lock_guard lock(seats_mutex_);
  if (manager_)
    caf::anon_send(manager_, actors::end_visit{name, time_.work.begin()});
}

Value NodeRuntime::slot_value(const SessionId& id, const std::string& topic,
                              const std::string& slot) {
  const auto session = sessions_.find(id);
  if (!session)
    return {};
  const auto told = questions().ask<slot_told>(
      session, get_slot{topic, slot, time_.work.begin()});
  return told ? told->value : Value();
}

std::string NodeRuntime::state_of(const SessionId& id) {
  const auto session = sessions_.find(id);
  if (!session)
    return {};
  const auto told =
      questions().ask<state_told>(session, get_state{time_.work.begin()});
  return told ? told->state : std::string();
}

void NodeRuntime::end_session(const SessionId& session) {
  caf::anon_send(manager_, close_session{session, time_.work.begin()});
}

// -- how it is ----------------------------------------------------------------

std::vector<ActorHandle> NodeRuntime::central_actors() const {
  std::vector<ActorHandle> all;
  add(all, message_centre_state::name, "", centre_);
  add(all, session_manager_state::name, "", manager_);
  add(all, supervisor_state::name, "", supervisor_);
  add(all, file_keeper_state::name, "", file_keeper_);
  return all;
}

// All but those that sessions have spawned; these are named by the sessions.
std::vector<ActorHandle> NodeRuntime::actors() const {
  auto all = central_actors();
  for (auto& handle : instances_.handles())
    all.push_back(std::move(handle));
  const auto first_seat = static_cast<std::ptrdiff_t>(all.size());
  {
    std::lock_guard lock(seats_mutex_);
    for (const auto& [name, seat] : seats_)
      add(all, seat_state::name, name, seat);
  }
  std::ranges::sort(all.begin() + first_seat, all.end(), {},
                    &ActorHandle::name);
  for (const auto& [id, session, seat] : sessions_.all())
    add(all, session_state::name, id, session);
  return all;
}

std::vector<ActorStatus> NodeRuntime::status(Milliseconds patience) {
  if (!system_)
    return {}; // it has stopped
  auto all = ask_all(actors(), patience, Children::asked);
  for (auto& one : all) {
    one.doing = observer_.discretion().masked_afterwards(one.doing);
    one.last_error = observer_.discretion().masked_afterwards(one.last_error);
  }
  return all;
}

std::vector<ActorStatus>
NodeRuntime::ask_all(const std::vector<ActorHandle>& whom,
                     Milliseconds patience, Children children) {
  auto let_run = [this] {
    if (!scheduler_->detaches())
      scheduler_->run_until_quiet();
  };
  return collect_status(*system_, whom, let_run, patience, children);
}

Metrics NodeRuntime::metrics(Milliseconds patience) {
  if (!system_)
    return {}; // it has stopped
  const auto central = ask_all(central_actors(), patience, Children::left_out);
  return collect_metrics({observer_.metrics(), *bus_.table(), central,
                          time_.work.held(), options_.journal.get()});
}

// -- bringing down ------------------------------------------------------------

bool NodeRuntime::stop() {
  if (time_.left_behind)
    return false;
  if (!system_)
    return true;
  time_.work.forget_interrupt();
  stop_sessions();
  stop_components();
  const bool idle = time_.work.none() && instances_.names_in_call().empty();
  const auto at_work = idle ? std::string("something") : who_is_at_work();
  auto end_remaining = [this] {
    stop_actors();
    system_->await_all_actors_done();
  };
  if (scheduler_->finish(end_remaining, options_.drain_time)) {
    if (options_.journal)
      options_.journal->forget_who_waits();
    system_.reset(); // here: CAF's logger belongs to the thread that made it
    return true;
  }
  observer_.log(at_work + " does not come to an end and is left behind");
  time_.left_behind = true;
  return false;
}

// Whoever is in a call or does not answer.
std::string NodeRuntime::who_is_at_work() {
  std::string names;
  for (const auto& status : status(patience_at_end))
    if (status.call_since || !status.answered)
      names += (names.empty() ? "" : ", ") +
               (status.name.empty() ? status.kind : status.name);
  return names.empty() ? "something" : names;
}

void NodeRuntime::stop_sessions() {
  end_session({});
  auto quiet = [this] { return time_.work.none(); };
  if (!scheduler_->run_until(quiet, options_.drain_time))
    observer_.log(who_is_at_work() +
                  " is still at work; stopping all the same");
}

void NodeRuntime::stop_components() {
  caf::anon_send(supervisor_, actors::stop_components{time_.work.begin()});
  scheduler_->run_until([this] { return time_.work.none(); },
                        options_.drain_time);
}

// In the order in which nobody is sent anything by those who still live.
void NodeRuntime::stop_actors() {
  constexpr auto reason = caf::exit_reason::user_shutdown;
  for (const auto& one : sessions_.all())
    caf::anon_send_exit(one.session, reason);
  {
    std::lock_guard lock(seats_mutex_); // visitors may still come and go
    for (auto& [name, seat] : std::exchange(seats_, {}))
      caf::anon_send_exit(seat, reason);
    caf::anon_send_exit(std::exchange(manager_, nullptr), reason);
  }
  caf::anon_send_exit(supervisor_, reason);
  caf::anon_send_exit(file_keeper_, reason);
  caf::anon_send_exit(centre_, reason);
  scheduler_->run_until_quiet();
  bus_.take_down();
  sessions_.clear();
  reloader_.reset(); // which holds handles, too
  supervisor_ = nullptr;
  file_keeper_ = nullptr;
  centre_ = nullptr;
}

} // namespace parlour::actors
