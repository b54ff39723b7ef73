// LogRobot (role Robot), a stand-in for a robot that goes to places and
// carries things, one at a time. It takes its time as a robot does; the order
// under way ends when it is told to stop or given another one.
//
//   Goto(place)    Arrived(place), or Failed(reason)
//   Grasp(thing)   Grasped(thing), or Failed(reason)
//   Release        lets go of what it holds; Say(text)
//   Stop           the order under way ends with Failed(stopped)
//   Sense(sensor)  Sensor(name, value) of place, hand or battery
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "adapters/standins/stand_in.hpp"

namespace parlour::adapters {

class LogRobot : public StandIn {
public:
  LogRobot() : StandIn("robot") {}

protected:
  Expected<void> on_options(const Options& options) override;
  bool carry_out(const Message& message) override;

private:
  // What is under way.
  struct Order {
    Message message;
    PluginHost::DelayId due = 0;
  };

  Expected<void> read_times(const Options& options);
  void go(const Message& order);
  void grasp(const Message& order);
  void sense(const std::string& sensor);
  // `done` happens unless the order ends before.
  void begin(const Message& order, Milliseconds takes,
             std::function<void()> done);
  void end_order(const std::string& reason);

  std::vector<std::string> places_; // empty: goes anywhere
  std::vector<std::string> things_; // empty: takes anything
  Milliseconds travel_{};
  Milliseconds grip_{};
  bool fails_ = false;
  std::string battery_;
  std::string place_;
  std::string hand_; // what it holds
  std::optional<Order> order_;
};

PluginFactory log_robot_factory();

} // namespace parlour::adapters
