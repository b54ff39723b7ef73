// Trials of sound devices for a user: what a microphone hears, and a tone from
// a speaker. The functions wait as long as they play or listen, in the pace of
// the device; one that hangs or breaks ends them with an error of kind Offline.
#pragma once

#include <functional>

#include "adapters/audio/alsa/device_stream.hpp"
#include "adapters/audio/level_meter.hpp"

namespace parlour::adapters {

// What was heard in 100 ms.
using OnLevel = std::function<void(const LevelMeter& level)>;

// Listens for so long; returns what was heard in all. `on_level` is called in
// the caller's thread.
Expected<LevelMeter> try_microphone(const std::string& device,
                                    Milliseconds time, const OnLevel& on_level,
                                    const StreamLimits& limits = {});

// Plays a tone of 440 Hz, 20 dB below full scale, that swells and fades.
Expected<void> try_speaker(const std::string& device, Milliseconds time,
                           const StreamLimits& limits = {});

// Plays sound of 16,000 samples a second and one channel.
Expected<void> play_sound(const std::string& device,
                          std::span<const Sample> samples,
                          const StreamLimits& limits = {});

} // namespace parlour::adapters
