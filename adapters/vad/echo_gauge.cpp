#include "adapters/vad/echo_gauge.hpp"

#include <algorithm>
#include <functional>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

namespace {

// Devices take so long from playing to hearing, and then the room goes on.
constexpr std::size_t delay_frames = 240 / frame_time;
constexpr int echo_lasts = 400 / frame_time;
constexpr double falls = 1.5; // dB a frame
// Sound of this moment, whatever the devices take.
constexpr std::size_t now_frames = 3;
// Softer sounds teach nothing: noise would be taken for echo.
constexpr double least_played = -45;
// A window has so many frames; its loudest ones, but for a knock, are those in
// which the echo was heard. So many windows are kept.
constexpr std::size_t window_frames = 600 / frame_time;
constexpr std::size_t knock_frames = 2;
constexpr std::size_t window_count = 8;
constexpr double least_coupling = -60;
constexpr double most_coupling = 10;
constexpr double silent_coupling = -35;
// The room colours each sound in another way.
constexpr double spread = 8;

} // namespace

EchoGauge::EchoGauge(double loss)
    : windows_{-loss - spread}, coupling_(windows_.front()) {}

void EchoGauge::plays(double level) {
  next_ = std::max(next_, level);
  left_ = echo_lasts;
}

void EchoGauge::hears(double level) {
  recent_.push_back(next_);
  next_ = lowest_level;
  if (recent_.size() > delay_frames)
    recent_.pop_front();
  const auto recent = *std::ranges::max_element(recent_);
  loudest_ = std::max({recent, loudest_ - falls, lowest_level});
  if (left_ == 0)
    return;
  --left_;
  if (recent >= loudest_ && recent > least_played)
    learn(level - recent);
}

double EchoGauge::playing() const {
  const auto count = std::min(recent_.size(), now_frames);
  auto loudest = lowest_level;
  for (auto at = recent_.size() - count; at < recent_.size(); ++at)
    loudest = std::max(loudest, recent_[at]);
  return loudest;
}

double EchoGauge::echo_of(double played) const {
  return played <= lowest_level ? lowest_level : played + coupling_;
}

bool EchoGauge::is_silent() const {
  return coupling_ < silent_coupling;
}

double EchoGauge::most_of(double played) const {
  return played <= lowest_level ? lowest_level : played + coupling_ + spread;
}

void EchoGauge::learn(double above_played) {
  window_.push_back(std::clamp(above_played, least_coupling, most_coupling));
  if (window_.size() < window_frames)
    return;
  const auto loud = window_.begin() + knock_frames;
  std::ranges::nth_element(window_, loud, std::greater());
  windows_.push_back(*loud);
  window_.clear();
  if (windows_.size() > window_count)
    windows_.pop_front();
  coupling_ = *std::ranges::min_element(windows_);
}

} // namespace parlour::adapters
