#include "adapters/audio/alsa/device_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace parlour::adapters {

namespace {

constexpr float full_scale = 32'768;

// A little-endian number of that many bytes, in the upper part of the result.
std::int32_t upper_bits(std::span<const std::byte> bytes) {
  std::uint32_t value = 0;
  for (const auto byte : bytes)
    value = value >> 8 | std::to_integer<std::uint32_t>(byte) << 24;
  return static_cast<std::int32_t>(value);
}

Sample sample_of(DeviceSamples kind, std::span<const std::byte> bytes) {
  switch (kind) {
  case DeviceSamples::s24: // the fourth byte may be anything
    return static_cast<Sample>(upper_bits(bytes.first(3)) >> 16);
  case DeviceSamples::float32: {
    float value = 0;
    std::memcpy(&value, bytes.data(), sizeof value);
    return std::isnan(value)
               ? Sample{0}
               : static_cast<Sample>(std::lround(std::clamp(
                     value * full_scale, -full_scale, full_scale - 1)));
  }
  default:
    return static_cast<Sample>(upper_bits(bytes) >> 16);
  }
}

// The lowest `count` bytes.
void append_number(std::int32_t value, std::size_t count,
                   std::vector<std::byte>& bytes) {
  for (std::size_t i = 0; i < count; ++i)
    bytes.push_back(static_cast<std::byte>(value >> (8 * i)));
}

void append_float(float value, std::vector<std::byte>& bytes) {
  std::byte raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.insert(bytes.end(), std::begin(raw), std::end(raw));
}

} // namespace

std::size_t bytes_of(DeviceSamples kind) {
  constexpr std::size_t sizes[] = {
#define X(name, bytes, sentence) bytes,
      PARLOUR_DEVICE_SAMPLES(X)
#undef X
  };
  return sizes[static_cast<std::size_t>(kind)];
}

void append_samples(DeviceSamples kind, std::span<const std::byte> bytes,
                    std::vector<Sample>& samples) {
  const auto size = bytes_of(kind);
  for (; bytes.size() >= size; bytes = bytes.subspan(size))
    samples.push_back(sample_of(kind, bytes.first(size)));
}

void append_bytes(DeviceSamples kind, std::span<const Sample> samples,
                  std::vector<std::byte>& bytes) {
  for (const auto sample : samples)
    switch (kind) {
    case DeviceSamples::s16:
      append_number(sample, 2, bytes);
      break;
    case DeviceSamples::s32:
      append_number(sample * 65'536, 4, bytes);
      break;
    case DeviceSamples::s24:
    case DeviceSamples::s24_3:
      append_number(sample * 256, bytes_of(kind), bytes);
      break;
    case DeviceSamples::float32:
      append_float(static_cast<float>(sample) / full_scale, bytes);
      break;
    }
}

} // namespace parlour::adapters
