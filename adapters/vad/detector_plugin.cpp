#include "adapters/vad/detector_plugin.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters {

namespace {

// A detector has 2 KiB or less.
constexpr std::size_t most_streams = 256;

} // namespace

DetectorPlugin::DetectorPlugin(MakeDetector make) : make_(std::move(make)) {}

Expected<void> DetectorPlugin::on_start(const Options& options) {
  options_ = options;
  return make_(options).map([](const auto&) {});
}

void DetectorPlugin::on_process(const Binary& audio,
                                std::optional<std::int64_t> position) {
  const Value value(audio);
  const auto samples = speech_samples(value);
  if (!samples)
    return refuse(samples.error().message);
  auto* const listening = detector();
  if (!listening)
    return;
  for (const auto& edge : listening->take(*samples, position))
    if (edge.begins)
      fire_speech_started(edge.position);
    else
      fire_speech_ended(edge.position);
}

void DetectorPlugin::on_set_echo(const Binary& audio) {
  const Value value(audio);
  const auto samples = speech_samples(value);
  if (!samples)
    return refuse(samples.error().message);
  if (auto* const listening = detector())
    listening->hear_echo(*samples);
}

void DetectorPlugin::on_reset() {
  streams_.erase(current().session);
}

SpeechDetector* DetectorPlugin::detector() {
  auto& stream = streams_[current().session];
  stream.used = ++uses_;
  if (!stream.detector)
    if (auto made = make_(options_))
      stream.detector = std::move(*made);
  auto* const found = stream.detector.get();
  if (streams_.size() > most_streams)
    drop_least_used();
  return found;
}

void DetectorPlugin::drop_least_used() {
  streams_.erase(std::ranges::min_element(
      streams_, {}, [](const auto& each) { return each.second.used; }));
}

} // namespace parlour::adapters
