#include "adapters/metrics/turn_metrics.hpp"

#include <utility>

namespace parlour::adapters {

namespace {

constexpr std::size_t most_sessions = 1'000;

} // namespace

TurnMetrics::TurnMetrics() : RolePlugin("Metrics") {
  on("TurnEnded", &TurnMetrics::on_turn_ended);
  on("Recognised", &TurnMetrics::on_recognised);
  on("Understood", &TurnMetrics::on_understood);
  on("Said", &TurnMetrics::on_said);
  on("Sounded", &TurnMetrics::on_sounded);
}

TurnTimes& TurnMetrics::times() {
  const auto session = current().session;
  if (times_.size() == most_sessions && !times_.contains(session))
    times_.clear();
  return times_[session];
}

void TurnMetrics::on_turn_ended(std::int64_t,
                                std::optional<std::int64_t> silence) {
  times().ended(now(), Milliseconds(silence.value_or(0)));
}

void TurnMetrics::on_recognised() {
  times().recognised(now());
}

void TurnMetrics::on_understood() {
  times().understood(now());
}

void TurnMetrics::on_said(std::int64_t utterance) {
  times().said(now(), utterance);
}

void TurnMetrics::on_sounded(std::int64_t utterance) {
  if (auto turn = times().sounded(now(), utterance))
    fire_event("Turn", {std::move(*turn)});
}

PluginFactory turn_metrics_factory() {
  return {{.name = "TurnMetrics",
           .roles = {"Metrics"},
           .sentence = "takes the time of each spoken turn"},
          [] { return std::make_unique<TurnMetrics>(); }};
}

} // namespace parlour::adapters
