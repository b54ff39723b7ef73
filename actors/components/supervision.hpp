// Supervision: the components of a node, and what becomes of them: loaded,
// replaced, unloaded, tried again after a failure, given up while they hang
// (engine rule 7.3). The supervisor's state; lives on its thread.
//
// A component comes (its instances start), is kept, and departs (its instances
// finish what they have, then stop). It has a branch for the house, or one for
// each seat or session: these come and go with them, break each for itself, and
// are replaced and unloaded together.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "actors/components/component.hpp"
#include "actors/routing/instance_directory.hpp"
#include "actors/routing/session_directory.hpp"
#include "actors/support/failure_record.hpp"
#include "runtime/plugin/catalogue.hpp"

namespace parlour::actors {

struct supervisor_state;

// How components are made here.
struct ComponentSettings {
  // What scripts can load; may be null.
  std::shared_ptr<PluginCatalogue> plugins = nullptr;
  // Completes what they load; may be empty.
  std::function<void(ComponentOrder&)> complete = {};
  // How long one may take to start, in real time.
  Milliseconds start_time{30'000};
  // How long a session waits for an answer.
  Milliseconds request_timeout{10'000};
  // Each instance gets a thread of its own.
  bool detaches = false;
};

struct SupervisionParts {
  NodeTime& time;
  MessageBus& bus;
  Observer& observer;
  const SessionDirectory& sessions;
  InstanceDirectory& instances;
  const PluginEnvironment& environment; // of the plug-ins
  ComponentSettings settings = {};
};

class Supervision {
public:
  using Self = supervisor_actor::stateful_pointer<supervisor_state>;

  // A component has no more: each costs a thread.
  static constexpr std::size_t most_branches = 1'000;

  Supervision(Self self, SupervisionParts parts)
      : self_(self), parts_(std::move(parts)) {}

  // -- what is wished --------------------------------------------------------
  void load(const load_component& what);
  void load(const load_plugin& what);
  void unload(const unload_component& what);
  void stop_all();

  // -- what happens ----------------------------------------------------------
  void started(const instance_started& what);
  void stopped(const instance_stopped& what);
  void failed(const component_failed& what);
  void watch(const watch_instance& what);
  void rests(const instance_rests& what);
  void try_again(const actors::try_again& what);
  void drain_over(const actors::drain_over& what);
  void opened(const seat_opened& what);
  void begins(const session_begins& what);
  void ended(const session_ended& what);

private:
  struct Kept;
  using KeptPointer = std::shared_ptr<Kept>;

  // What one place has of a component: a mailbox, instances, their failures.
  struct Branch {
    std::shared_ptr<Component> component;
    std::shared_ptr<Place> place;
    FailureRecord failures;
    std::shared_ptr<const InlinePlugin> direct;
    bool pauses = false;     // no instance is made for now
    bool handed_on = false;  // its mailbox is another's by now
    bool over = false;       // its place is: nobody waits for its answers
    std::uint64_t trial = 0; // which try_again counts
    DueTicket due;           // of that
    // They begin when it has finished: else what was said last might be
    // answered first.
    std::vector<InstanceId> successors;

    const std::string& name() const {
      return component->name();
    }
  };
  using BranchPointer = std::shared_ptr<Branch>;

  struct Kept {
    ComponentOrder order;
    std::size_t rank = 0;
    std::map<std::string, BranchPointer> branches; // by place
    // Those of the sessions, for the table; null: there is the house's only.
    std::shared_ptr<Branches> by_session;
    bool tell = false; // of its coming
    Done done;         // while it comes
  };

  enum class Stage { starts, works, leaves, stops };
  struct Entry {
    std::shared_ptr<Instance> instance;
    component_host_actor host;
    BranchPointer branch;
    Stage stage = Stage::starts;
  };

  struct Departure {
    std::vector<BranchPointer> branches;
    std::string unloads; // the component's name; empty: nobody is told
    Done done;
    DueTicket due; // of drain_over
  };

  // -- coming: supervision_loading.cpp
  Expected<void> may_come(const ComponentOrder& order) const;
  void come(const ComponentOrder& order, std::size_t rank, bool tell,
            Done done);
  void came(const KeptPointer& kept);
  void takes_place(const KeptPointer& kept);
  void came_not(const KeptPointer& kept, Error error);
  Expected<ComponentOrder> order_for(const load_plugin& what) const;

  // -- departing: supervision_loading.cpp
  static std::vector<BranchPointer> branches_of(const Kept& kept);
  void depart(std::vector<BranchPointer> branches, const std::string& unloads,
              Done done);
  void withdraw(Branch& branch);
  void see_off(std::uint64_t departure, bool at_once);
  bool has_finished(const Entry& entry) const;
  void gone(std::uint64_t departure);
  void begin(const std::vector<InstanceId>& instances);
  std::uint64_t departure_of(const BranchPointer& branch) const;

  // -- seats and sessions: supervision_places.cpp
  std::vector<KeptPointer> all_kept() const;
  void settle(const KeptPointer& kept);
  void welcome(const KeptPointer& kept, const SessionId& session,
               const seat_actor& seat);
  BranchPointer branch_for(const KeptPointer& kept,
                           const std::shared_ptr<Place>& place);
  std::shared_ptr<ComponentMailbox> mailbox_at(const std::string& name,
                                               const Place& place) const;
  BranchPointer add_branch(const KeptPointer& kept,
                           const std::shared_ptr<Place>& place);
  void take_leave(const KeptPointer& kept, const SessionId& session);

  // -- instances: supervision.cpp
  void make_missing(const BranchPointer& branch);
  void make_instance(const BranchPointer& branch);
  DoorParts door_parts() const;
  component_host_actor host_for(const std::shared_ptr<Instance>& instance);
  void stop(Entry& entry);
  void remove(InstanceId id, const std::string& reason);
  void close(Entry& entry, const std::string& reason);
  std::vector<InstanceId> instances_of(const Branch& branch) const;
  bool is_kept(const BranchPointer& branch) const;
  KeptPointer is_coming(const BranchPointer& branch) const;
  static bool has(const Kept& kept, const BranchPointer& branch);
  void works(Entry& entry);
  void joins(const Entry& entry);
  // Of a call that it is in now.
  Milliseconds deadline_of(const Entry& entry) const;
  void hangs(InstanceId id);

  // -- failures: supervision.cpp
  void count_failure(const BranchPointer& branch, const std::string& reason);
  void rest(const BranchPointer& branch, const std::string& reason,
            Milliseconds pause);
  void after_end(const BranchPointer& branch);
  void try_later(Branch& branch, Milliseconds pause);

  // -- telling
  void publish_table();
  void tell(const char* event, std::vector<Value> params,
            const SessionId& session = {});
  void tell_up(const Component& component, const SessionId& session = {});
  void answer_by_failure(const Branch& branch,
                         const std::vector<Message>& messages,
                         const std::string& reason);
  void answer_what_waits(const Branch& branch, const std::string& reason);
  DueTicket ticket(Milliseconds delay);

  Self self_;
  const SupervisionParts parts_;
  std::map<std::string, KeptPointer> kept_;   // by name
  std::map<std::string, KeptPointer> coming_; // by name
  // What the settings say of components, by name; without what makes them.
  std::map<std::string, ComponentOrder> settled_;
  std::map<std::uint64_t, Departure> departures_;
  std::map<InstanceId, Entry> entries_;
  const std::shared_ptr<Place> house_ = std::make_shared<Place>();
  std::map<seat_actor, std::shared_ptr<Place>> seats_;
  InstanceId last_instance_ = 0;
  std::uint64_t last_number_ = 0; // of departures and trials
  std::size_t last_rank_ = 0;
  bool closing_ = false;
};

} // namespace parlour::actors
