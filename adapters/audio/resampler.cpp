#include "adapters/audio/resampler.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace parlour::adapters {

namespace {

constexpr float full_scale = 32'768;

Sample to_sample(float value) {
  return static_cast<Sample>(
      std::lround(std::clamp(value * full_scale, -32'768.0F, 32'767.0F)));
}

// Brings samples to -1..1. If only one channel is wanted, it is the mean of
// all, so that it cannot be too loud.
void mix(std::span<const Sample> samples, int from, int to,
         std::vector<float>& mixed) {
  const auto width = static_cast<std::size_t>(from / to);
  const auto scale = full_scale * static_cast<float>(width);
  for (auto rest = samples; rest.size() >= width; rest = rest.subspan(width)) {
    const auto frame = rest.first(width);
    const auto sum = std::accumulate(frame.begin(), frame.end(), 0);
    mixed.push_back(static_cast<float>(sum) / scale);
  }
}

} // namespace

Expected<Resampler> Resampler::create(const PcmFormat& from,
                                      const PcmFormat& to) {
  if (from.rate == to.rate)
    return Resampler(from, to, std::nullopt);
  const auto channels = from.channels == to.channels ? from.channels : 1;
  return RateConverter::create(from.rate, to.rate, channels)
      .map([&](RateConverter converter) {
        return Resampler(from, to, std::move(converter));
      });
}

Resampler::Resampler(const PcmFormat& from, const PcmFormat& to,
                     std::optional<RateConverter> converter)
    : from_(from), to_(to),
      inner_(from.channels == to.channels ? from.channels : 1),
      converter_(std::move(converter)) {}

void Resampler::process(std::span<const Sample> samples,
                        std::vector<Sample>& out) {
  if (from_ == to_) {
    out.insert(out.end(), samples.begin(), samples.end());
    return;
  }
  mixed_.clear();
  mix(samples, from_.channels, inner_, mixed_);
  if (!converter_)
    return spread(mixed_, out);
  converted_.clear();
  converter_->process(mixed_, converted_);
  spread(converted_, out);
}

void Resampler::finish(std::vector<Sample>& out) {
  if (!converter_)
    return;
  converted_.clear();
  converter_->finish(converted_);
  spread(converted_, out);
}

void Resampler::spread(std::span<const float> mixed,
                       std::vector<Sample>& out) const {
  const auto copies = static_cast<std::size_t>(to_.channels / inner_);
  for (const auto value : mixed)
    out.insert(out.end(), copies, to_sample(value));
}

} // namespace parlour::adapters
