// Levels of sound, noise, and sounds that are mixed. 16,000 samples a second,
// one channel; levels are of the mean power, in dB of full scale. Pure; the
// same seed gives the same samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

using Sound = std::vector<Sample>;

constexpr std::size_t samples_in(std::int64_t milliseconds) {
  return static_cast<std::size_t>(milliseconds) * speech_rate / 1'000;
}

double level_of(std::span<const Sample> sound);
// That of the parts where something is heard (within 25 dB of the loudest).
double speech_level_of(std::span<const Sample> sound);

// So much louder or weaker; what is too loud is cut off.
Sound at_level(Sound sound, double from, double to);
// Values of any size, as a sound of this level.
Sound sound_of(std::span<const double> values, double level);
// Adds `sound` from this sample on; what is longer is cut off.
void add(Sound& to, std::span<const Sample> sound, std::size_t at = 0);
// Without what is silent at the beginning and at the end (35 dB below the
// loudest).
Sound without_silence(const Sound& sound);

// Equal power in each octave, as in many rooms.
Sound pink_noise(std::uint64_t seed, std::int64_t milliseconds, double level);
// Equal power at each frequency.
Sound white_noise(std::uint64_t seed, std::int64_t milliseconds, double level);

} // namespace parlour::adapters
