// The protocol's events for audio of 16,000 samples a second, one channel.
// Pure functions.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "adapters/audio/pcm.hpp"
#include "adapters/wyoming/event.hpp"

namespace parlour::adapters::wyoming {

// In bytes; a second.
inline constexpr std::size_t longest_audio = std::size_t{2} * speech_rate;

// Times are in ms since the audio began.
Event audio_start();
// `samples`: 16 bits each, in the order of this machine's bytes.
Event audio_chunk(const std::string& samples, std::int64_t time);
Event audio_stop(std::int64_t time);

// Samples as bytes and back. Half a sample at the end is dropped.
std::string bytes_of(std::span<const Sample> samples);
std::vector<Sample> samples_of(const std::string& bytes);
// In ms, at 16,000 samples a second.
std::int64_t duration_of(const std::string& bytes);

// Without blanks at both ends.
std::string trimmed(const std::string& text);

} // namespace parlour::adapters::wyoming
