// Supervision: the components of a node, and what becomes of them: loaded,
// replaced, unloaded, tried again after a failure, given up while they hang
// (session.md, "Components while running"). The supervisor's state; lives on
// its thread.
//
// A component comes (its instances start), is kept, and departs (its instances
// finish what they have, then stop).
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "actors/component.hpp"
#include "actors/failure_record.hpp"

namespace parlour::actors {

struct supervisor_state;

class Supervision {
public:
  using Self = supervisor_actor::stateful_pointer<supervisor_state>;

  Supervision(Self self, Services& services)
      : self_(self), services_(services) {}

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

private:
  struct Kept {
    std::shared_ptr<Component> component;
    std::size_t rank = 0;
    FailureRecord failures;
    std::shared_ptr<const InlinePlugin> direct;
    bool pauses = false;     // no instance is made for now
    bool tell = false;       // of its coming
    std::uint64_t trial = 0; // which try_again counts
    DueTicket due;           // of that
    Done done;               // while it comes
  };
  using KeptPointer = std::shared_ptr<Kept>;

  enum class Stage { starts, works, leaves, stops };
  struct Entry {
    std::shared_ptr<Instance> instance;
    component_host_actor host;
    KeptPointer kept;
    Stage stage = Stage::starts;
  };

  struct Departure {
    KeptPointer kept;
    bool unloads = false; // else its mailbox is another's by now
    Done done;
    DueTicket due; // of drain_over
  };

  // -- coming: supervision_loading.cpp
  Expected<void> may_come(const ComponentOrder& order) const;
  void come(const ComponentOrder& order, std::size_t rank, bool tell,
            Done done);
  void came(const KeptPointer& kept);
  void came_not(const KeptPointer& kept, Error error);
  Expected<ComponentOrder> order_for(const load_plugin& what) const;

  // -- departing: supervision_loading.cpp
  void depart(KeptPointer kept, bool unloads, Done done);
  void see_off(std::uint64_t departure, bool at_once);
  bool has_finished(const Entry& entry, const Departure& departure) const;
  void gone(std::uint64_t departure);
  std::uint64_t departure_of(const KeptPointer& kept) const;

  // -- instances: supervision.cpp
  void make_missing(const KeptPointer& kept);
  void make_instance(const KeptPointer& kept);
  component_host_actor host_for(const std::shared_ptr<Instance>& instance);
  void stop(Entry& entry);
  void remove(InstanceId id, const std::string& reason);
  void close(Entry& entry, const std::string& reason);
  std::vector<InstanceId> instances_of(const KeptPointer& kept) const;
  bool is_kept(const KeptPointer& kept) const;
  bool is_coming(const KeptPointer& kept) const;
  void works(Entry& entry);
  void joins(const Entry& entry);
  void hangs(InstanceId id);

  // -- failures: supervision.cpp
  void count_failure(const KeptPointer& kept, const std::string& reason);
  void rest(const KeptPointer& kept, const std::string& reason,
            Milliseconds pause);
  void after_end(const KeptPointer& kept);
  void try_later(const KeptPointer& kept, Milliseconds pause);

  // -- telling
  void publish_table();
  void tell(const char* event, std::vector<Value> params);
  void tell_up(const Component& component);
  void answer_by_failure(const KeptPointer& kept,
                         const std::vector<Message>& messages,
                         const std::string& reason);
  void answer_what_waits(const KeptPointer& kept, const std::string& reason);
  DueTicket ticket(Milliseconds delay);

  Self self_;
  Services& services_;
  std::map<std::string, KeptPointer> kept_;   // by name
  std::map<std::string, KeptPointer> coming_; // by name
  // What the settings say of components, by name; without what makes them.
  std::map<std::string, ComponentOrder> settled_;
  std::map<std::uint64_t, Departure> departures_;
  std::map<InstanceId, Entry> entries_;
  InstanceId last_instance_ = 0;
  std::uint64_t last_number_ = 0; // of departures and trials
  std::size_t last_rank_ = 0;
  bool closing_ = false;
};

} // namespace parlour::actors
