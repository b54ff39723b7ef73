// TurnMetrics is a plug-in for the role Metrics: it takes the time of each
// spoken turn (turn_times.hpp). Relays tell it what happens
// (config/platform/turn-times.xml):
//
//  TurnEnded(position, silence?), Recognised(), Understood(),
//  Said(utterance)
//  Sounded(utterance)
//      Turn(times), if it is the first sound of the answer.
//
// Each session has times of its own; those of a thousand sessions are kept.
#pragma once

#include <map>
#include <optional>

#include "adapters/metrics/turn_times.hpp"
#include "runtime/plugin/role_plugin.hpp"

namespace parlour::adapters {

class TurnMetrics : public RolePlugin {
public:
  TurnMetrics();

private:
  void on_turn_ended(std::int64_t position,
                     std::optional<std::int64_t> silence);
  void on_recognised();
  void on_understood();
  void on_said(std::int64_t utterance);
  void on_sounded(std::int64_t utterance);

  TurnTimes& times(); // of the message's session
  Timestamp now() const {
    return host().clock().now();
  }

  std::map<SessionId, TurnTimes> times_;
};

PluginFactory turn_metrics_factory();

} // namespace parlour::adapters
