#include "adapters/vad/adaptive_detector.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters {

namespace {

constexpr std::size_t kept_frames = 4'000 / frame_time;
// Before so many frames are known, the noise is not believed to be loud:
// somebody may speak from the first frame on.
constexpr std::size_t trusted_frames = 500 / frame_time;
constexpr double loudest_first_noise = -50; // dB of full scale
constexpr double noise_percentile = 0.2;
// The peak is one that lasts for so many frames, which a knock does not, and
// falls by so much each frame: 1 dB a second, since people wait for answers.
constexpr std::size_t peak_frames = 4;
constexpr double peak_decay = 1.0 * frame_time / 1'000;
// Before anybody has spoken, it is expected that somebody will be so loud.
constexpr double first_peak = -30; // dB of full scale
// The margin above the noise grows with its spread, which is that of the levels
// between these percentiles: speech is hardly among them.
constexpr double low_percentile = 0.1;
constexpr double high_percentile = 0.35;
constexpr int strong_frames = 2;
// Weak sounds at the edges of speech: so much above the noise and below the
// peak, in dB, and for at most so many frames.
constexpr double edge_margin = 3;
constexpr double edge_below_peak = 28;
constexpr std::size_t edge_frames = 10;
// Who talks over the robot may have begun so long before being noticed, with
// such gaps; what is so much above the usual echo is no echo.
constexpr std::size_t hidden_frames = 1'000 / frame_time;
constexpr std::size_t hidden_gap = 120 / frame_time;
constexpr double above_echo = 3;

} // namespace

AdaptiveDetector::AdaptiveDetector(const Settings& settings)
    : settings_(settings), echo_(settings.echo_loss) {
  reset();
}

void AdaptiveDetector::reset() {
  meter_ = {};
  echo_meter_ = {};
  stream_ = {};
  frames_.clear();
  sorted_.clear();
  peak_ = first_peak;
  echo_ = EchoGauge(settings_.echo_loss);
  in_speech_ = false;
  silent_frames_ = 0;
}

std::vector<SpeechEdge>
AdaptiveDetector::take(std::span<const Sample> audio,
                       std::optional<std::int64_t> position) {
  stream_.take(
      audio, position, [&] { end_at_gap(); },
      [&](std::span<const Sample> frame) { take_frame(frame); });
  return std::exchange(found_, {});
}

// The levels are still those of the room, but no speech reaches over a gap.
void AdaptiveDetector::end_at_gap() {
  if (in_speech_)
    found_.push_back({false, stream_.position_before(silent_frames_)});
  in_speech_ = false;
  for (auto& frame : frames_)
    frame.voiced = false;
}

void AdaptiveDetector::hear_echo(std::span<const Sample> audio) {
  echo_.plays(echo_meter_.level(audio));
}

void AdaptiveDetector::take_frame(std::span<const Sample> frame) {
  const auto level = meter_.level(frame);
  echo_.hears(level);
  follow(level);
  frames_.back().voiced = level > threshold();
  if (in_speech_)
    end_if_silent();
  else
    begin_if_voiced();
}

// Takes the level into what is known of noise and peak.
void AdaptiveDetector::follow(double level) {
  if (frames_.size() == kept_frames) {
    sorted_.erase(std::ranges::lower_bound(sorted_, frames_.front().level));
    frames_.pop_front();
  }
  frames_.push_back({level, echo_.played(), false});
  sorted_.insert(std::ranges::lower_bound(sorted_, level), level);
  peak_ -= peak_decay;
  // How loud the robot is tells nothing of how loud people are.
  if (frames_.size() < peak_frames || level < echo_.most_of(echo_.played()))
    return;
  auto lasting = level;
  for (auto at = frames_.size() - peak_frames; at < frames_.size(); ++at)
    lasting = std::min(lasting, frames_[at].level);
  peak_ = std::max(peak_, lasting);
}

double AdaptiveDetector::percentile(double which) const {
  return sorted_[static_cast<std::size_t>(
      which * static_cast<double>(sorted_.size() - 1))];
}

double AdaptiveDetector::noise() const {
  const auto level = percentile(noise_percentile);
  return sorted_.size() < trusted_frames ? std::min(level, loudest_first_noise)
                                         : level;
}

double AdaptiveDetector::least_margin() const {
  const auto spread = percentile(high_percentile) - percentile(low_percentile);
  return std::clamp(settings_.margin_of_spread * spread + 2,
                    settings_.least_margin, settings_.most_least);
}

double AdaptiveDetector::weakest_of_speech() const {
  return std::max(noise() + edge_margin, peak_ - edge_below_peak);
}

double AdaptiveDetector::threshold_without_echo() const {
  if (sorted_.empty())
    return settings_.least_level;
  const auto floor = noise();
  const auto above = peak_ - floor;
  const auto margin = std::clamp(
      std::max(settings_.between * above, above - settings_.most_below_peak),
      least_margin(), settings_.most_margin);
  return std::max(floor + margin, settings_.least_level);
}

// An echo must not begin speech; within speech it can only make it longer, and
// once the speaker has faded out, it is not waited for.
double AdaptiveDetector::threshold() const {
  return std::max(threshold_without_echo(),
                  in_speech_ ? echo_.echo_of(echo_.playing()) + above_echo
                             : echo_.most_of(echo_.played()));
}

void AdaptiveDetector::begin_if_voiced() {
  const auto first = frames_.end() - static_cast<std::ptrdiff_t>(onset_size());
  const auto voiced = std::count_if(
      first, frames_.end(), [](const Frame& frame) { return frame.voiced; });
  if (voiced < settings_.onset_voiced)
    return;
  const auto strong = threshold() + settings_.onset_strength;
  if (std::count_if(first, frames_.end(), [&](const Frame& frame) {
        return frame.level > strong;
      }) < strong_frames)
    return;
  in_speech_ = true;
  silent_frames_ = 0;
  found_.push_back(
      {true, stream_.position_before(frames_.size() - first_of_speech())});
}

std::size_t AdaptiveDetector::onset_size() const {
  return std::min(frames_.size(),
                  static_cast<std::size_t>(settings_.onset_frames));
}

// The index of the first frame that belongs to the speech that begins: back
// over the voiced frames, then over weak ones.
std::size_t AdaptiveDetector::first_of_speech() const {
  auto at = frames_.size() - onset_size();
  while (!frames_[at].voiced)
    ++at;
  if (frames_[at].played > lowest_level)
    at = first_beside_echo(at);
  const auto weak = weakest_of_speech();
  const auto earliest = at - std::min(at, edge_frames);
  while (at > earliest && frames_[at - 1].level > weak)
    --at;
  return at;
}

std::size_t AdaptiveDetector::first_beside_echo(std::size_t at) const {
  const auto least = threshold_without_echo();
  const auto earliest = at - std::min(at, hidden_frames);
  auto first = at;
  for (; at > earliest && first - at <= hidden_gap; --at) {
    const auto& frame = frames_[at - 1];
    if (frame.level > std::max(least, echo_.echo_of(frame.played) + above_echo))
      first = at - 1;
  }
  return first;
}

void AdaptiveDetector::end_if_silent() {
  silent_frames_ = frames_.back().voiced ? 0 : silent_frames_ + 1;
  if (silent_frames_ * frame_time <
      static_cast<std::size_t>(settings_.hangover))
    return;
  in_speech_ = false;
  const auto weak = weakest_of_speech();
  auto after = silent_frames_;
  while (after > 0 && frames_[frames_.size() - after].level > weak)
    --after;
  found_.push_back({false, stream_.position_before(after)});
}

} // namespace parlour::adapters
