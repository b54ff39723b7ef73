// The kinds of samples that sound devices have, and their conversion to 16 bit
// and back. Pure functions; safe from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

// All of them little-endian: DEVICE_SAMPLES(name, bytes, sentence), the best
// first.
// clang-format off
#define PARLOUR_DEVICE_SAMPLES(X) \
  X(s16, 2, "16 bit") \
  X(s32, 4, "32 bit") \
  X(s24, 4, "24 bit in four bytes") \
  X(s24_3, 3, "24 bit in three bytes") \
  X(float32, 4, "floating point")
// clang-format on

enum class DeviceSamples : std::uint8_t {
#define X(name, bytes, sentence) name,
  PARLOUR_DEVICE_SAMPLES(X)
#undef X
};

std::size_t bytes_of(DeviceSamples kind);

// Appends samples; half of one at the end is left out.
void append_samples(DeviceSamples kind, std::span<const std::byte> bytes,
                    std::vector<Sample>& samples);
void append_bytes(DeviceSamples kind, std::span<const Sample> samples,
                  std::vector<std::byte>& bytes);

} // namespace parlour::adapters
