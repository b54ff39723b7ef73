// Sounds for tests of what hears: tones, noise, and their mixing. 16,000
// samples a second, one channel. The same seed gives the same samples.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "adapters/audio/mixing.hpp"

namespace parlour::test {

using adapters::add;
using adapters::at_level;
using adapters::level_of;
using adapters::pink_noise;
using adapters::samples_in;
using adapters::Sound;
using adapters::speech_level_of;

Sound silence(std::int64_t milliseconds);
// Levels are of the mean power, in dB of full scale.
Sound tone(double hertz, std::int64_t milliseconds, double level);
// Voiced bursts with pauses, with the rhythm and the spectrum of syllables: for
// machines without a synthesiser. Begins and ends with sound.
Sound speech_like(std::uint64_t seed, std::int64_t milliseconds, double level);
// Several of them at once.
Sound speech_like_babble(std::uint64_t seed, std::int64_t milliseconds,
                         double level, int voices = 6);

// Adds the noise, so much weaker than the speech; the noise begins anywhere, by
// the seed, and is repeated.
void add_noise(Sound& speech, const Sound& noise, double decibels,
               std::uint64_t seed);

// So many samples of the mean of two sounds that are repeated, from this sample
// on.
Sound mixed_loops(const Sound& one, const Sound& other, std::size_t at,
                  std::size_t length);

} // namespace parlour::test
