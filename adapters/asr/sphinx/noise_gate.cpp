#include "adapters/asr/sphinx/noise_gate.hpp"

#include <algorithm>
#include <utility>

#include "adapters/audio/mixing.hpp"

namespace parlour::adapters::asr {

namespace {

constexpr std::size_t gate_samples = speech_rate / 100; // a frame of 10 ms
// The noise is below this share of the first frames.
constexpr std::size_t first_frames = 25;
constexpr std::size_t which_of_first = 5;
// No room is more silent, in dB of full scale.
constexpr double least_noise = -70;
// So much louder is speech, and so many frames around it belong to it.
constexpr double above_noise = 10;
constexpr std::size_t around_speech = 6;
// The gain of a closed gate: 40 dB less.
constexpr double closed = 0.01;
// How fast it opens and closes, for each sample.
constexpr double speed = 0.02;

} // namespace

// A frame leaves only when those behind it are known: whether speech follows
// decides whether it is kept.
std::vector<Sample> NoiseGate::take(std::span<const Sample> audio) {
  std::vector<Sample> passed;
  for (const auto sample : audio) {
    part_.push_back(sample);
    if (part_.size() < gate_samples)
      continue;
    add_frame();
    while (noise_ && kept_.size() > around_speech)
      pass(passed);
  }
  return passed;
}

std::vector<Sample> NoiseGate::finish() {
  std::vector<Sample> passed;
  if (!part_.empty())
    add_frame();
  learn_noise();
  while (!kept_.empty())
    pass(passed);
  *this = {};
  return passed;
}

void NoiseGate::add_frame() {
  const auto level = level_of(part_);
  kept_.push_back({std::exchange(part_, {}), level});
  if (!noise_ && kept_.size() == first_frames)
    learn_noise();
}

// A low percentile: who begins to speak at once is not taken for noise.
void NoiseGate::learn_noise() {
  if (noise_ || kept_.empty())
    return;
  std::vector<double> levels;
  for (const auto& frame : kept_)
    levels.push_back(frame.level);
  std::ranges::sort(levels);
  noise_ = std::max(least_noise,
                    levels[std::min(which_of_first, levels.size() - 1)]);
}

// Speech is not far, before or behind.
bool NoiseGate::is_open() const {
  const auto end =
      kept_.begin() +
      static_cast<std::ptrdiff_t>(std::min(kept_.size(), around_speech + 1));
  return since_loud_ <= around_speech ||
         std::any_of(kept_.begin(), end, [&](const Frame& frame) {
           return frame.level > *noise_ + above_noise;
         });
}

// The gain moves sample by sample: a jump would sound like a stop consonant.
void NoiseGate::pass(std::vector<Sample>& to) {
  const auto wanted = is_open() ? 1 : closed;
  const auto& frame = kept_.front();
  since_loud_ = frame.level > *noise_ + above_noise ? 0 : since_loud_ + 1;
  for (const auto sample : frame.samples) {
    gain_ += (wanted - gain_) * speed;
    to.push_back(static_cast<Sample>(sample * gain_));
  }
  kept_.pop_front();
}

} // namespace parlour::adapters::asr
