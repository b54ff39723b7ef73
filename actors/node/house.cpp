#include "actors/node/house.hpp"

#include <algorithm>
#include <cassert>
#include <future>
#include <numeric>
#include <utility>

#include <caf/scoped_actor.hpp>
#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/components/supervisor.hpp"
#include "actors/routing/message_centre.hpp"
#include "actors/sessions/file_keeper.hpp"
#include "actors/sessions/session_manager.hpp"

namespace parlour::actors {

namespace {

std::unique_ptr<Drive> make_drive(const NodeOptions& options) {
  return options.virtual_start ? make_virtual_drive(*options.virtual_start)
                               : make_real_drive(options.threads);
}

PluginEnvironment plugin_environment(const NodeOptions& options) {
  return {options.phrases,
          options.understanding ? options.understanding
                                : options.program->understanding,
          options.columns, options.data_folder, options.application_folder};
}

} // namespace

House::House(NodeOptions options)
    : options_(std::move(options)), drive_(make_drive(options_)),
      chance_(options_.seed), time_(drive_->clock(), drive_->gate()),
      observer_(watcher(), time_.left_behind),
      plugin_environment_(plugin_environment(options_)),
      bus_(time_, observer_, options_.program, options_.aliases) {
  drive_->configure(config_);
  system_ = std::make_unique<caf::actor_system>(config_);
  drive_->attach(*system_, time_);
  spawn_actors();
}

House::~House() {
  [[maybe_unused]] const bool down = stop();
  assert(down);
}

// -- bringing up --------------------------------------------------------------

Observer::Watcher House::watcher() {
  Observer::Watcher watcher;
  watcher.on_inspection = options_.on_inspection;
  watcher.all = options_.inspect_all;
  watcher.exact = options_.exact_inspections;
  watcher.on_log = options_.log;
  if (script::has_private(*options_.program))
    watcher.is_heard = [this](const Message& message) {
      return bus_.is_heard(message);
    };
  return watcher;
}

void House::spawn_actors() {
  supervisor_ = system_->spawn(supervisor, supervision_parts());
  file_keeper_ =
      drive_->detaches()
          ? system_->spawn<caf::detached>(file_keeper, options_.files)
          : system_->spawn(file_keeper, options_.files);
  const SessionNames names{[this] { return chance_.session_id(); },
                           [this] { return chance_.session_seed(); }};
  manager_ =
      system_->spawn(session_manager, session_parts(), &sessions_, names);
  centre_ = system_->spawn(message_centre, &bus_, &sessions_, manager_);
  bus_.connect(centre_);
}

SupervisionParts House::supervision_parts() {
  ComponentSettings settings;
  settings.plugins = options_.plugins;
  settings.complete = options_.complete;
  settings.start_time = options_.start_time;
  settings.request_timeout =
      options_.program->settings.sessions.request_timeout;
  settings.detaches = drive_->detaches();
  return {time_,   bus_, observer_, sessions_, instances_, plugin_environment_,
          settings};
}

SessionParts House::session_parts() {
  return {time_,
          bus_,
          observer_,
          options_.program,
          options_.phrases,
          options_.sockets,
          {},
          supervisor_,
          file_keeper_};
}

Expected<void> House::start_components() {
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

// Others read from the databases when they start.
std::vector<std::size_t> House::in_starting_order() const {
  std::vector<std::size_t> order(options_.components.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_partition(order, [this](std::size_t rank) {
    const auto& roles = options_.components[rank].factory.description.roles;
    return std::ranges::find(roles, "Database") != roles.end();
  });
  return order;
}

Expected<void> House::start(std::size_t rank) {
  return wish([&](Done done, Work work) {
    caf::anon_send(supervisor_,
                   load_component{std::make_shared<const ComponentOrder>(
                                      std::move(options_.components[rank])),
                                  rank + 1, std::move(done), std::move(work)});
  });
}

Expected<void> House::load(const std::string& plugin, const std::string& name) {
  return wish([&](Done done, Work work) {
    caf::anon_send(supervisor_,
                   load_plugin{plugin, name, std::move(done), std::move(work)});
  });
}

Expected<void> House::unload(const std::string& name) {
  return wish([&](Done done, Work work) {
    caf::anon_send(supervisor_,
                   unload_component{name, std::move(done), std::move(work)});
  });
}

Expected<void> House::wish(const std::function<void(Done, Work)>& send) {
  auto outcome = std::make_shared<std::promise<Expected<void>>>();
  auto future = outcome->get_future();
  send([outcome](
           Expected<void> result) { outcome->set_value(std::move(result)); },
       time_.work.begin());
  auto done = [&](Milliseconds patience) {
    return future.wait_for(patience) == std::future_status::ready;
  };
  // What departs may take its time.
  while (drive_->run_until_quiet() && !done(Milliseconds(0)) &&
         drive_->step_to_next_due(options_.drain_time)) {
  }
  if (time_.work.interrupted() || !done(options_.drain_time))
    return fail(ErrorKind::cancelled, "interrupted");
  return future.get();
}

// -- sessions -----------------------------------------------------------------

seat_actor House::open_seat(const std::string& name, SeatCalls calls) {
  seats_.push_back(system_->spawn(
      seat, SeatParts{&time_, &observer_, &sessions_}, std::move(calls)));
  const auto& opened = seats_.back();
  caf::anon_send(manager_, seat_opened{name, opened, time_.work.begin()});
  caf::anon_send(supervisor_, seat_opened{name, opened, time_.work.begin()});
  return opened;
}

SessionId House::open_session(const seat_actor& seat) {
  caf::scoped_actor self(*system_);
  auto answer = self->request(manager_, caf::infinite,
                              actors::open_session{seat, time_.work.begin()});
  SessionId id;
  if (!drive_->run_until_quiet())
    return id;
  answer.receive([&](session_opened& opened) { id = opened.session; },
                 [&](const caf::error& error) {
                   observer_.log("no session: " + system_->render(error));
                 });
  return id;
}

void House::end_session(const SessionId& session) {
  caf::anon_send(manager_, close_session{session, time_.work.begin()});
}

// -- bringing down ------------------------------------------------------------

bool House::stop() {
  if (time_.left_behind)
    return false;
  if (!system_)
    return true;
  time_.work.forget_interrupt();
  stop_sessions();
  stop_components();
  const auto at_work = who_is_at_work();
  auto rest = [this] {
    stop_actors();
    system_->await_all_actors_done();
  };
  if (drive_->finish(rest, options_.drain_time)) {
    system_.reset(); // here: CAF's logger belongs to the thread that made it
    return true;
  }
  observer_.log(at_work + " does not come to an end and is left behind");
  time_.left_behind = true;
  return false;
}

// The components whose call does not return, or else something: a seat.
std::string House::who_is_at_work() const {
  const auto names = instances_.names_in_call();
  return names.empty() ? "something" : names;
}

void House::stop_sessions() {
  end_session({});
  auto quiet = [this] { return time_.work.none(); };
  if (!drive_->run_until(quiet, options_.drain_time))
    observer_.log(who_is_at_work() +
                  " is still at work; stopping all the same");
}

void House::stop_components() {
  caf::anon_send(supervisor_, actors::stop_components{time_.work.begin()});
  drive_->run_until([this] { return time_.work.none(); }, options_.drain_time);
}

void House::stop_actors() {
  constexpr auto reason = caf::exit_reason::user_shutdown;
  for (auto& session : sessions_.all())
    caf::anon_send_exit(session, reason);
  for (auto& seat : std::exchange(seats_, {}))
    caf::anon_send_exit(seat, reason);
  caf::anon_send_exit(manager_, reason);
  caf::anon_send_exit(supervisor_, reason);
  caf::anon_send_exit(file_keeper_, reason);
  caf::anon_send_exit(centre_, reason);
  drive_->run_until_quiet();
  bus_.take_down();
  sessions_.clear();
  manager_ = nullptr;
  supervisor_ = nullptr;
  file_keeper_ = nullptr;
  centre_ = nullptr;
}

} // namespace parlour::actors
