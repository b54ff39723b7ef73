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

} // namespace

House::House(NodeOptions options)
    : options_(std::move(options)), drive_(make_drive(options_)),
      chance_(options_.seed),
      services_(drive_->clock(), drive_->gate(), watcher()) {
  set_up_services();
  set_up_routing();
  drive_->configure(config_);
  system_ = std::make_unique<caf::actor_system>(config_);
  drive_->attach(*system_, services_.time);
  spawn_actors();
}

House::~House() {
  [[maybe_unused]] const bool down = stop();
  assert(down);
}

// -- bringing up --------------------------------------------------------------

void House::set_up_services() {
  services_.program = options_.program;
  services_.phrases = options_.phrases;
  services_.understanding = options_.understanding
                                ? options_.understanding
                                : options_.program->understanding;
  services_.columns = options_.columns;
  services_.data_folder = options_.data_folder;
  services_.application_folder = options_.application_folder;
  services_.start_time = options_.start_time;
  services_.detaches = drive_->detaches();
  services_.plugins = options_.plugins;
  services_.complete = options_.complete;
  services_.files = options_.files;
  services_.sockets = options_.sockets;
  services_.new_session_id = [this] { return chance_.session_id(); };
  services_.new_seed = [this] { return chance_.session_seed(); };
}

Observer::Watcher House::watcher() {
  Observer::Watcher watcher;
  watcher.on_inspection = options_.on_inspection;
  watcher.all = options_.inspect_all;
  watcher.exact = options_.exact_inspections;
  watcher.on_log = options_.log;
  if (script::has_private(*options_.program))
    watcher.is_heard = [this](const Message& message) {
      return services_.is_heard(message);
    };
  return watcher;
}

void House::spawn_actors() {
  services_.centre = system_->spawn(message_centre, &services_);
  services_.supervisor = system_->spawn(supervisor, &services_);
  services_.manager = system_->spawn(session_manager, &services_);
  services_.file_keeper =
      drive_->detaches()
          ? system_->spawn<caf::detached>(file_keeper, &services_)
          : system_->spawn(file_keeper, &services_);
}

// A table that nobody fills a role of, until the components are up.
void House::set_up_routing() {
  auto& parts = services_.routing;
  parts.program = options_.program;
  parts.aliases = options_.aliases;
  parts.clock = &services_.time.clock;
  parts.counters = services_.counters;
  parts.complain = [this](const Message& message, const Error& error) {
    services_.failed(message, error);
  };
  if (services_.observer.follows_messages())
    parts.taps.push_back(
        [this](const Message& message, const std::string& way) {
          services_.observer.follow(message, way);
        });
  services_.table.store(std::make_shared<const RoutingTable>(parts));
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
    caf::anon_send(services_.supervisor,
                   load_component{std::make_shared<const ComponentOrder>(
                                      std::move(options_.components[rank])),
                                  rank + 1, std::move(done), std::move(work)});
  });
}

Expected<void> House::load(const std::string& plugin, const std::string& name) {
  return wish([&](Done done, Work work) {
    caf::anon_send(services_.supervisor,
                   load_plugin{plugin, name, std::move(done), std::move(work)});
  });
}

Expected<void> House::unload(const std::string& name) {
  return wish([&](Done done, Work work) {
    caf::anon_send(services_.supervisor,
                   unload_component{name, std::move(done), std::move(work)});
  });
}

Expected<void> House::wish(const std::function<void(Done, Work)>& send) {
  auto outcome = std::make_shared<std::promise<Expected<void>>>();
  auto future = outcome->get_future();
  send([outcome](
           Expected<void> result) { outcome->set_value(std::move(result)); },
       services_.time.work.begin());
  auto done = [&](Milliseconds patience) {
    return future.wait_for(patience) == std::future_status::ready;
  };
  // What departs may take its time.
  while (drive_->run_until_quiet() && !done(Milliseconds(0)) &&
         drive_->step_to_next_due(options_.drain_time)) {
  }
  if (services_.time.work.interrupted() || !done(options_.drain_time))
    return fail(ErrorKind::cancelled, "interrupted");
  return future.get();
}

// -- sessions -----------------------------------------------------------------

seat_actor House::open_seat(const std::string& name, SeatCalls calls) {
  seats_.push_back(system_->spawn(seat, &services_, std::move(calls)));
  const auto& opened = seats_.back();
  caf::anon_send(services_.manager,
                 seat_opened{name, opened, services_.time.work.begin()});
  caf::anon_send(services_.supervisor,
                 seat_opened{name, opened, services_.time.work.begin()});
  return opened;
}

SessionId House::open_session(const seat_actor& seat) {
  caf::scoped_actor self(*system_);
  auto answer =
      self->request(services_.manager, caf::infinite,
                    actors::open_session{seat, services_.time.work.begin()});
  SessionId id;
  if (!drive_->run_until_quiet())
    return id;
  answer.receive([&](session_opened& opened) { id = opened.session; },
                 [&](const caf::error& error) {
                   services_.observer.log("no session: " +
                                          system_->render(error));
                 });
  return id;
}

// -- bringing down ------------------------------------------------------------

bool House::stop() {
  if (services_.time.left_behind)
    return false;
  if (!system_)
    return true;
  services_.time.work.forget_interrupt();
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
  services_.observer.log(at_work +
                         " does not come to an end and is left behind");
  services_.time.left_behind = true;
  return false;
}

// The components whose call does not return, or else something: a seat.
std::string House::who_is_at_work() const {
  const auto names = services_.instances.names_in_call();
  return names.empty() ? "something" : names;
}

void House::stop_sessions() {
  caf::anon_send(services_.manager,
                 close_session{{}, services_.time.work.begin()});
  auto quiet = [this] { return services_.time.work.none(); };
  if (!drive_->run_until(quiet, options_.drain_time))
    services_.observer.log(who_is_at_work() +
                           " is still at work; stopping all the same");
}

void House::stop_components() {
  caf::anon_send(services_.supervisor,
                 actors::stop_components{services_.time.work.begin()});
  drive_->run_until([this] { return services_.time.work.none(); },
                    options_.drain_time);
}

void House::stop_actors() {
  constexpr auto reason = caf::exit_reason::user_shutdown;
  for (auto& session : services_.sessions.all())
    caf::anon_send_exit(session, reason);
  for (auto& seat : std::exchange(seats_, {}))
    caf::anon_send_exit(seat, reason);
  caf::anon_send_exit(services_.manager, reason);
  caf::anon_send_exit(services_.supervisor, reason);
  caf::anon_send_exit(services_.file_keeper, reason);
  caf::anon_send_exit(services_.centre, reason);
  drive_->run_until_quiet();
  services_.table.store(nullptr);
  services_.sessions.clear();
  services_.manager = nullptr;
  services_.supervisor = nullptr;
  services_.file_keeper = nullptr;
  services_.centre = nullptr;
}

} // namespace parlour::actors
