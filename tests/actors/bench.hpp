// Bench: runs single actors in virtual time without a node. Everything that the
// actor under test sends goes to probes, actors that note each message as a
// line of `seen`. For one thread.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <caf/send.hpp>
#include <caf/typed_event_based_actor.hpp>

#include "actors/node/scheduler.hpp"
#include "actors/routing/message_bus.hpp"
#include "actors/routing/session_directory.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {

// Of a probe.
inline constexpr auto no_status = [](const get_status& what) {
  return status_told{what.number, {}};
};

// What a session of a test does by itself; the rest it ignores, until it is
// ended.
struct SessionCalls {
  std::function<void()> begins;
  std::function<void(const timer_due&)> rings;
  std::function<void()> wakes;
  std::function<void(const query_outcome&)> is_answered =
      [](const query_outcome&) {};
};

inline session_actor::behavior_type session_with(session_actor::pointer self,
                                                 const SessionCalls& calls) {
  return {
      [begins = calls.begins](const begin_session&) { begins(); },
      [](const deliver&) {},
      [](const take_step&) {},
      [rings = calls.rings](const timer_due& what) { rings(what); },
      [wakes = calls.wakes](const wake_up&) { wakes(); },
      [answered = calls.is_answered](const query_outcome& what) {
        answered(what);
      },
      [](const file_outcome&) {},
      [](const socket_told&) {},
      [](const output_done&) {},
      [](const get_slot&) { return slot_told{}; },
      [](const get_state&) { return state_told{}; },
      [self](const end_session&) { self->quit(); },
      [](const record_written&) {},
      [](const change_program&) { return program_changed(); },
      [](const scripts_over&) {},
      [](const rest_if_idle&) {},
      [](const leave&) {},
      no_status,
  };
}

class Bench {
public:
  // `elements` are the children of <dialogue>, `targets` the components in the
  // routing table.
  explicit Bench(const std::string& elements = "",
                 std::vector<Target> targets = {})
      : program(compile(elements)) {
    scheduler->configure(config_);
    system = std::make_unique<caf::actor_system>(config_);
    scheduler->attach(*system, time);
    set_table(std::move(targets));
  }

  ~Bench() {
    for (const auto& one : sessions.all())
      caf::anon_send_exit(one.session, caf::exit_reason::kill);
    for (const auto& actor : spawned_)
      caf::anon_send_exit(actor, caf::exit_reason::kill);
    run();
    sessions.clear();
    bus.take_down();
    spawned_.clear();
    run(); // what went with them may have sent something
  }

  void set_table(std::vector<Target> targets) {
    bus.set_targets(std::move(targets));
  }

  template <class... Arguments>
  auto spawn(Arguments&&... arguments) {
    auto actor = system->spawn(std::forward<Arguments>(arguments)...);
    spawned_.push_back(caf::actor_cast<caf::strong_actor_ptr>(actor));
    return actor;
  }

  // Sends a message and runs until all actors are idle.
  template <class Actor, class What>
  void send(const Actor& actor, What what) {
    caf::anon_send(actor, std::move(what));
    run();
  }

  // Inspections go to `show`. Call it before anything is watched or logged.
  void watch(std::function<void(const Inspection&)> show, bool all = true) {
    std::destroy_at(&observer);
    std::construct_at(&observer, watcher(std::move(show), all),
                      time.left_behind);
  }

  void run() {
    scheduler->run_until_quiet();
  }

  InFlight work() {
    return time.work.begin();
  }

  // -- probes: they note what they get in `seen` ---------------------------

  session_actor session_probe(const std::string& name) {
    auto note = [this, name](const std::string& what) {
      seen.push_back(name + " " + what);
    };
    return spawn(
        [note](session_actor::pointer self,
               Bench*) -> session_actor::behavior_type {
          return {
              [=](const begin_session&) { note("begins"); },
              [=](const deliver& what) {
                for (const auto& message : what.messages)
                  note("gets " + to_string(message));
              },
              [=](const take_step&) { note("steps"); },
              [=](const timer_due& what) {
                note("rings " + std::to_string(what.id));
              },
              [=](const wake_up&) { note("wakes"); },
              [=](const query_outcome&) { note("has an outcome"); },
              [=](const file_outcome& what) {
                note("has of a file " +
                     (what.outcome ? to_string(*what.outcome)
                                   : to_string(what.outcome.error())));
              },
              [=](const socket_told& what) {
                note("is told " + what.event.text);
              },
              [=](const output_done& what) {
                note((what.played ? "played " : "did not play ") +
                     std::to_string(what.id));
              },
              [](const get_slot&) { return slot_told{}; },
              [](const get_state&) { return state_told{}; },
              [=](const end_session&) {
                note("ends");
                self->quit();
              },
              [](const record_written&) {},
              [](const change_program&) { return program_changed(); },
              [](const scripts_over&) {},
              [](const rest_if_idle&) {},
              [=](const leave&) { self->quit(); },
              no_status,
          };
        },
        this);
  }

  seat_actor seat_probe() {
    return spawn(
        [this](seat_actor::pointer, Bench*) -> seat_actor::behavior_type {
          return {
              [this](const say& what) {
                seen.push_back("says " + what.output->text);
              },
              [this](const session_over& what) {
                seen.push_back(what.session + " is over");
              },
              [this](const next_session& what) {
                seen.push_back(what.session + " is next");
              },
              [this](const turns_done& what) {
                seen.push_back(what.session + " has answered " +
                               std::to_string(what.turn));
              },
              [this](const leave_seat&) { seen.emplace_back("leaves"); },
              no_status,
          };
        },
        this);
  }

  query_actor query_probe() {
    return spawn(
        [this](query_actor::pointer, Bench*) -> query_actor::behavior_type {
          return {
              [this](const component_event& what) {
                seen.push_back("event " + to_string(what.event));
              },
              [](const give_up&) {},
              no_status,
          };
        },
        this);
  }

  message_centre_actor centre_probe() {
    return spawn(
        [this](message_centre_actor::pointer self,
               Bench*) -> message_centre_actor::behavior_type {
          return {
              [this](const publish& what) {
                for (const auto& message : what.messages)
                  seen.push_back("outside: " + to_string(message));
              },
              [this](const distribute& what) {
                for (const auto& message : what.messages)
                  seen.push_back(to_string(message));
              },
              [=](const retire& what) {
                self->send(what.session, leave{what.work});
              },
              [=](const ring& what) { self->send(what.session, what.what); },
              no_status,
          };
        },
        this);
  }

  // A component with a mailbox that a probe reads.
  Target target(const std::string& name, std::vector<std::string> roles) {
    auto mailbox = std::make_shared<ComponentMailbox>();
    mailbox->add_worker(component_probe(name, mailbox));
    return {name, std::move(roles), std::move(mailbox), nullptr,
            std::make_shared<std::atomic<bool>>(true)};
  }

  component_host_actor
  component_probe(const std::string& name,
                  std::shared_ptr<ComponentMailbox> mailbox = nullptr) {
    return spawn(
        [=, this](component_host_actor::pointer self,
                  Bench*) -> component_host_actor::behavior_type {
          return {
              [](const start_component&) {},
              [=, this](const mailbox_ready&) {
                while (auto job = mailbox->take(self))
                  seen.push_back(name + " gets " + to_string(*job->message));
              },
              [this, name](const run_after& what) {
                seen.push_back(name + " is to wait");
                what.action();
                time.due_times.remove(what.due->id());
              },
              [](const run_now&) {},
              [](const stop_component&) {},
              no_status,
          };
        },
        this);
  }

  std::unique_ptr<Scheduler> scheduler = make_virtual_time(nine_o_clock);
  NodeTime time{scheduler->clock(), scheduler->queue_kind()};
  Observer observer{watcher({}, true), time.left_behind};
  SessionDirectory sessions;
  const std::shared_ptr<const script::Program> program;
  MessageBus bus{time, observer, program};
  std::unique_ptr<caf::actor_system> system;
  std::vector<std::string> logs;
  std::vector<std::string> seen;

private:
  Observer::Watcher watcher(std::function<void(const Inspection&)> show,
                            bool all) {
    Observer::Watcher watcher;
    watcher.on_inspection = std::move(show);
    watcher.all = all;
    watcher.on_log = [this](const std::string& line) { logs.push_back(line); };
    return watcher;
  }

  caf::actor_system_config config_;
  std::vector<caf::strong_actor_ptr> spawned_;
};

inline Message event(std::string source, std::string command,
                     std::vector<Value> params = {}, SessionId session = "") {
  Message message;
  message.source = std::move(source);
  message.command = std::move(command);
  message.params = std::move(params);
  message.session = std::move(session);
  return message;
}

inline SharedMessage shared(Message message) {
  return std::make_shared<const Message>(std::move(message));
}

} // namespace parlour::actors
