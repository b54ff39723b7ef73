// The level of a piece of audio without its lowest sounds (hum, wind, steps),
// in dB of full scale.
#pragma once

#include <span>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

// Silence, also what digital silence has.
inline constexpr double lowest_level = -96;

// Keeps the state of its filter from one piece to the next. Not thread-safe.
class SpeechBandMeter {
public:
  // lowest_level for an empty piece.
  double level(std::span<const Sample> audio);

private:
  double last_in_ = 0;
  double last_out_ = 0;
};

} // namespace parlour::adapters
