// House: a node's actors, brought up and down in order. What node.hpp hides.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <caf/actor_system.hpp>
#include <caf/actor_system_config.hpp>

#include "actors/node/drive.hpp"
#include "actors/node/node.hpp"
#include "actors/routing/services.hpp"
#include "actors/sessions/seat.hpp"
#include "actors/support/chance.hpp"

namespace parlour::actors {

class House {
public:
  explicit House(NodeOptions options);
  ~House();

  // Starts the components in order; an error stops those that are up.
  Expected<void> start_components();
  // While it runs; both return when it is done, or with an error of kind
  // Cancelled when interrupted.
  Expected<void> load(const std::string& plugin, const std::string& name);
  Expected<void> unload(const std::string& name);
  seat_actor open_seat(const std::string& name, SeatCalls calls);
  SessionId open_session(const seat_actor& seat);
  // Sessions, then components, then the rest, each for at most the drain time;
  // safe to call again. False where something does not come to an end: this
  // house may then never be destroyed.
  bool stop();

  Services& services() {
    return services_;
  }
  Drive& drive() {
    return *drive_;
  }

private:
  Observer::Watcher watcher();
  void set_up_services();
  void spawn_actors();
  void set_up_routing();
  // Of the components: places in the order of preference.
  std::vector<std::size_t> in_starting_order() const;
  Expected<void> start(std::size_t rank);
  // Sends a wish to the supervisor and runs until it is done.
  Expected<void> wish(const std::function<void(Done, Work)>& send);
  void stop_sessions();
  void stop_components();
  void stop_actors();
  std::string who_is_at_work() const;

  // In the order of their making: what is below may use what is above.
  NodeOptions options_;
  std::unique_ptr<Drive> drive_;
  Chance chance_;
  Services services_;
  caf::actor_system_config config_;
  std::unique_ptr<caf::actor_system> system_;
  std::vector<seat_actor> seats_;
};

} // namespace parlour::actors
