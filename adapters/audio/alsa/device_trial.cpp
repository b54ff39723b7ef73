#include "adapters/audio/alsa/device_trial.hpp"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <numbers>
#include <optional>
#include <utility>

#include "adapters/audio/resampler.hpp"

namespace parlour::adapters {

namespace {

constexpr int frequency = 440;
constexpr double tone_level = 0.1; // of full scale
constexpr Milliseconds step{100};
constexpr Milliseconds filled{10};

// Both trials: they run until they are over or the device is lost.
class Trial : public StreamUser {
public:
  bool is_running() override {
    return !over_;
  }
  void begin(const PcmFormat& format) override {
    format_ = format;
  }
  void lost(const std::string& reason) override {
    std::lock_guard lock(mutex_);
    lost_ = reason;
    changed_.notify_all();
  }
  void found() override {}

protected:
  // Samples of all channels.
  std::size_t samples_in(Milliseconds time) const {
    return static_cast<std::size_t>(time.count() * format_.rate / 1'000 *
                                    format_.channels);
  }
  void end() {
    std::lock_guard lock(mutex_);
    over_ = true;
    changed_.notify_all();
  }

  PcmFormat format_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool over_ = false; // the stream's thread writes it, under the lock
  std::optional<std::string> lost_;
};

class Listener : public Trial {
public:
  explicit Listener(Milliseconds time) : time_(time) {}

  void captured(std::span<const Sample> samples, Milliseconds) override {
    for (auto rest = samples; !rest.empty() && !over_;) {
      const auto left = samples_in(step) - level_.samples();
      const auto count = std::min<std::size_t>(rest.size(), left);
      level_.add(rest.first(count));
      all_.add(rest.first(count));
      rest = rest.subspan(count);
      if (level_.samples() >= samples_in(step))
        next_level();
    }
  }

  // Waits for the end.
  Expected<LevelMeter> wait(const OnLevel& on_level) {
    std::unique_lock lock(mutex_);
    while (!lost_ && (!over_ || !levels_.empty())) {
      changed_.wait(lock,
                    [this] { return lost_ || over_ || !levels_.empty(); });
      for (const auto& level : std::exchange(levels_, {})) {
        lock.unlock();
        on_level(level);
        lock.lock();
      }
    }
    if (lost_)
      return fail(ErrorKind::offline, *lost_);
    return all_;
  }

private:
  void next_level() {
    std::unique_lock lock(mutex_);
    levels_.push_back(std::exchange(level_, {}));
    changed_.notify_all();
    lock.unlock();
    if (all_.samples() >= samples_in(time_))
      end();
  }

  const Milliseconds time_;
  LevelMeter level_;
  LevelMeter all_;
  std::deque<LevelMeter> levels_;
};

// What is played, in the format of the device, and silence behind its end.
class Playing : public Trial {
public:
  void fill(std::vector<Sample>& samples) override {
    const auto wanted = samples.size() + samples_in(filled);
    while (samples.size() < wanted)
      samples.insert(samples.end(), static_cast<std::size_t>(format_.channels),
                     next(frames_++));
  }
  void waiting(std::size_t samples) override {
    const auto heard =
        frames_ - static_cast<std::int64_t>(samples) / format_.channels;
    if (heard >= length())
      end();
  }

  Expected<void> wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return lost_ || over_; });
    if (lost_)
      return fail(ErrorKind::offline, *lost_);
    return {};
  }

protected:
  // In frames of the device.
  virtual std::int64_t length() const = 0;
  virtual Sample next(std::int64_t frame) const = 0;

private:
  std::int64_t frames_ = 0; // that were filled
};

class Tone : public Playing {
public:
  explicit Tone(Milliseconds time) : time_(time) {}

private:
  std::int64_t length() const override {
    return time_.count() * format_.rate / 1'000;
  }
  Sample next(std::int64_t frame) const override {
    if (frame >= length())
      return 0;
    const auto at = static_cast<double>(frame) / format_.rate;
    const auto swell = std::sin(std::numbers::pi * static_cast<double>(frame) /
                                static_cast<double>(length()));
    return static_cast<Sample>(
        std::lround(32'767 * tone_level * swell *
                    std::sin(2 * std::numbers::pi * frequency * at)));
  }

  const Milliseconds time_;
};

class Sound : public Playing {
public:
  explicit Sound(std::span<const Sample> samples) : samples_(samples) {}

  // It begins anew where the device is opened again, at another rate perhaps.
  void begin(const PcmFormat& format) override {
    Playing::begin(format);
    converted_.clear();
    auto resampler = Resampler::create({}, {format.rate, 1});
    if (!resampler)
      return lost(resampler.error().message);
    resampler->process(samples_, converted_);
    resampler->finish(converted_);
  }

private:
  std::int64_t length() const override {
    return std::ssize(converted_);
  }
  Sample next(std::int64_t frame) const override {
    return frame < length() ? converted_[static_cast<std::size_t>(frame)]
                            : Sample{0};
  }

  const std::span<const Sample> samples_;
  std::vector<Sample> converted_;
};

// The trial must outlive the stream.
Expected<std::unique_ptr<DeviceStream>> start(const std::string& device,
                                              SoundDirection direction,
                                              const StreamLimits& limits,
                                              Trial& trial) {
  return DeviceStream::start({device, direction}, limits, trial);
}

} // namespace

Expected<LevelMeter> try_microphone(const std::string& device,
                                    Milliseconds time, const OnLevel& on_level,
                                    const StreamLimits& limits) {
  Listener listener(time);
  const auto stream = start(device, SoundDirection::capture, limits, listener);
  if (!stream)
    return tl::make_unexpected(stream.error());
  return listener.wait(on_level);
}

Expected<void> try_speaker(const std::string& device, Milliseconds time,
                           const StreamLimits& limits) {
  Tone tone(time);
  const auto stream = start(device, SoundDirection::playback, limits, tone);
  if (!stream)
    return tl::make_unexpected(stream.error());
  return tone.wait();
}

Expected<void> play_sound(const std::string& device,
                          std::span<const Sample> samples,
                          const StreamLimits& limits) {
  Sound sound(samples);
  const auto stream = start(device, SoundDirection::playback, limits, sound);
  if (!stream)
    return tl::make_unexpected(stream.error());
  return sound.wait();
}

} // namespace parlour::adapters
