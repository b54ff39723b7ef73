#include "adapters/vad/adaptive_vad.hpp"

#include <memory>
#include <utility>

#include "adapters/vad/adaptive_detector.hpp"
#include "adapters/vad/detector_options.hpp"
#include "adapters/vad/detector_plugin.hpp"

namespace parlour::adapters {

namespace {

Expected<std::unique_ptr<SpeechDetector>> make(const Options& given) {
  const auto options = read_detector_options(given);
  if (!options)
    return tl::make_unexpected(options.error());
  AdaptiveDetector::Settings settings;
  settings.hangover = options->hangover;
  settings.echo_loss = options->echo_loss;
  return std::make_unique<AdaptiveDetector>(settings);
}

} // namespace

PluginFactory adaptive_vad_factory() {
  PluginDescription description;
  description.name = "AdaptiveVAD";
  description.roles = {"VAD"};
  description.sentence = "finds speech by its level above the noise";
  description.options = detector_options();
  return {std::move(description),
          [] { return std::make_unique<DetectorPlugin>(make); }};
}

} // namespace parlour::adapters
