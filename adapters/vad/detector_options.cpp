#include "adapters/vad/detector_options.hpp"

#include "runtime/base/clock.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

std::vector<OptionDescription>
detector_options(std::vector<OptionDescription> own) {
  own.push_back({"hangover", "200ms",
                 "speech has ended when there was none for so long, 40ms to 2s",
                 false, OptionType::duration});
  own.push_back(
      {"echo-loss", "10",
       "by how many dB the microphone hears less of the loudspeaker, 0 to 60",
       false, OptionType::number});
  return own;
}

Expected<DetectorOptions> read_detector_options(const Options& given) {
  static const auto descriptions = detector_options();
  const auto hangover =
      parse_duration(option_value(given, descriptions, "hangover"));
  if (!hangover || hangover->count() < 40 || hangover->count() > 2'000)
    return fail(ErrorKind::settings, "the option 'hangover' is 40ms to 2s");
  const auto loss = parse_number(option_value(given, descriptions, "echo-loss"))
                        .number_or(-1);
  if (loss < 0 || loss > 60)
    return fail(ErrorKind::settings, "the option 'echo-loss' is 0 to 60");
  return DetectorOptions{static_cast<int>(hangover->count()), loss};
}

} // namespace parlour::adapters
