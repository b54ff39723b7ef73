#include "adapters/vad/webrtc_vad.hpp"

#include <memory>
#include <utility>

#include "adapters/vad/detector_options.hpp"
#include "adapters/vad/detector_plugin.hpp"
#include "adapters/vad/webrtc_detector.hpp"

namespace parlour::adapters {

namespace {

const std::vector<OptionDescription>& option_descriptions() {
  static const auto descriptions = detector_options(
      {{"strictness", "2",
        "from 0 (takes much for speech) to 3 (only what surely is)", false,
        OptionType::integer}});
  return descriptions;
}

Expected<std::unique_ptr<SpeechDetector>> make(const Options& given) {
  const auto options = read_detector_options(given);
  if (!options)
    return tl::make_unexpected(options.error());
  const auto strictness =
      parse_number(option_value(given, option_descriptions(), "strictness"))
          .integer_or(-1);
  if (strictness < 0 || strictness > 3)
    return fail(ErrorKind::settings, "the option 'strictness' is 0 to 3");
  WebRtcDetectorSettings settings;
  settings.strictness = static_cast<int>(strictness);
  settings.hangover = options->hangover;
  settings.echo_loss = options->echo_loss;
  return make_webrtc_detector(settings);
}

} // namespace

PluginFactory webrtc_vad_factory() {
  PluginDescription description;
  description.name = "WebRtcVAD";
  description.roles = {"VAD"};
  description.sentence = "finds speech by the detector of WebRTC";
  description.options = option_descriptions();
  return {std::move(description),
          [] { return std::make_unique<DetectorPlugin>(make); }};
}

} // namespace parlour::adapters
