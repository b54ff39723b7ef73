// Audio as messages carry it: a Binary value with 16 bit samples in the
// machine's byte order and the format "pcm_s16le;rate=16000;channels=1".
//
// Between components audio travels in frames of 20 ms, 16,000 samples a second,
// one channel. The bytes of a value are shared, so a relayed frame is not
// copied. Pure functions; safe from any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "runtime/base/error.hpp"
#include "runtime/base/value.hpp"

namespace parlour::adapters {

using Sample = std::int16_t;

// What components exchange unless they agree on something else.
inline constexpr int speech_rate = 16'000; // samples a second
inline constexpr int frame_time = 20;      // milliseconds
inline constexpr std::size_t frame_samples =
    std::size_t{speech_rate} * frame_time / 1'000;

struct PcmFormat {
  int rate = speech_rate; // samples a second, of each channel
  int channels = 1;

  bool operator==(const PcmFormat&) const = default;
};

// "pcm_s16le;rate=16000;channels=1"
std::string format_name(const PcmFormat& format);

// Reads such a name. Refuses another encoding, a rate outside of 4,000 to
// 384,000 and more than 32 channels. Rate and channels may be missing: 16,000
// and 1.
Expected<PcmFormat> parse_format(std::string_view name);

Value pcm_value(std::span<const Sample> samples, const PcmFormat& format = {});

// The samples of a value, which must outlive them. Refuses a value that is no
// audio of one channel at 16,000 samples a second, or has half a sample.
Expected<std::span<const Sample>> speech_samples(const Value& audio);
Expected<std::span<const Sample>> speech_samples(const Binary& audio);
Expected<std::span<const Sample>> speech_samples(Value&&) = delete;

// Milliseconds, rounded down.
constexpr std::int64_t duration(std::size_t samples, int rate = speech_rate) {
  return static_cast<std::int64_t>(samples) * 1'000 / rate;
}

} // namespace parlour::adapters
