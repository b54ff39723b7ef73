// LogRobot (role Robot) is a stand-in for a robot that goes to places and
// carries things, one at a time. Its orders take time, as a robot's do. A new
// order, or Stop, ends the current one.
//
//  Goto(place)    Arrived(place), or Failed(reason)
//  Grasp(thing)   Grasped(thing), or Failed(reason)
//  Release        lets go of what it holds
//  Say(text)      has no answer
//  Stop           the current order ends with Failed(stopped)
//  Sense(sensor)  Sensor(name, value), of place, hand or battery
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
  // The current order and the timer of its end.
  struct Order {
    Message message;
    PluginHost::DelayId due = 0;
  };

  Expected<void> read_times(const Options& options);
  void go(const Message& order);
  void grasp(const Message& order);
  void sense(const std::string& sensor);
  // Ends the current order and starts a new one; `done` is called when its time
  // is over.
  void begin(const Message& order, Milliseconds takes,
             std::function<void()> done);
  void end_order(const std::string& reason);

  // The places and things it knows; empty: all.
  std::vector<std::string> places_;
  std::vector<std::string> things_;
  Milliseconds travel_{};
  Milliseconds grip_{};
  bool fails_ = false;
  std::string battery_;
  std::string place_;
  // What it holds; empty: nothing.
  std::string hand_;
  std::optional<Order> order_;
};

PluginFactory log_robot_factory();

} // namespace parlour::adapters
