#include "adapters/audio/alsa/alsa_microphone.hpp"

#include <utility>

namespace parlour::adapters {

namespace {

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> options = {
      {"device", "default", "the device, as ALSA knows it, such as hw:1"}};
  return options;
}

} // namespace

AlsaMicrophone::AlsaMicrophone(StreamLimits limits) : limits_(limits) {}

AlsaMicrophone::~AlsaMicrophone() {
  stream_.reset();
}

Expected<void> AlsaMicrophone::on_start(const Options& options) {
  WantedDevice wanted;
  wanted.name = option_value(options, option_descriptions(), "device");
  wanted.direction = SoundDirection::capture;
  return DeviceStream::start(wanted, limits_, *this).map([&](auto stream) {
    stream_ = std::move(stream);
  });
}

void AlsaMicrophone::stop() {
  if (stream_ && !stream_->stop())
    host().log("The microphone's driver hangs; its thread is left to itself.");
  stream_.reset();
}

// -- commands
// ------------------------------------------------------------------

void AlsaMicrophone::on_start_mic() {
  std::unique_lock lock(mutex_);
  if (lost_)
    return refuse(*lost_);
  if (!std::exchange(wanted_, true)) {
    position_ = 0;
    ready_.clear();
    make_resampler();
  }
  lock.unlock();
  fire_started();
  stream_->wake();
}

void AlsaMicrophone::on_stop_mic() {
  std::unique_lock lock(mutex_);
  wanted_ = false;
  lock.unlock();
  fire_stopped();
  stream_->wake();
}

void AlsaMicrophone::on_set_format(std::int64_t rate, std::int64_t channels) {
  std::lock_guard lock(mutex_);
  if (wanted_)
    return refuse("the format can be set while the microphone is stopped");
  if (rate < 8'000 || rate > 48'000 || channels < 1 || channels > 2)
    return refuse("a rate from 8000 to 48000 and 1 or 2 channels can be had");
  format_ = {static_cast<int>(rate), static_cast<int>(channels)};
}

// -- sound, on the stream's thread
// ---------------------------------------------

bool AlsaMicrophone::is_running() {
  std::lock_guard lock(mutex_);
  return wanted_;
}

// A rate that cannot be converted is that of no sound device.
void AlsaMicrophone::begin(const PcmFormat& format) {
  std::lock_guard lock(mutex_);
  device_format_ = format;
  make_resampler();
}

void AlsaMicrophone::make_resampler() {
  if (auto made = Resampler::create(device_format_, format_))
    resampler_ = std::move(*made);
  else
    host().failed(made.error().message);
}

void AlsaMicrophone::captured(std::span<const Sample> samples,
                              Milliseconds lost) {
  std::lock_guard lock(mutex_);
  if (!wanted_ || !resampler_)
    return;
  position_ += lost.count();
  resampler_->process(samples, ready_);
  fire_frames();
}

void AlsaMicrophone::fire_frames() {
  const auto size = static_cast<std::size_t>(format_.rate * format_.channels) *
                    frame_time / 1'000;
  std::span<const Sample> rest = ready_;
  for (; rest.size() >= size; rest = rest.subspan(size)) {
    answer({}, "BufferFull", {pcm_value(rest.first(size), format_), position_});
    position_ += frame_time;
  }
  ready_.erase(ready_.begin(), ready_.end() - std::ssize(rest));
}

void AlsaMicrophone::lost(const std::string& reason) {
  std::unique_lock lock(mutex_);
  lost_ = reason;
  lock.unlock();
  host().log(reason);
  answer({}, "Failed", {reason});
  host().available(false);
}

void AlsaMicrophone::found() {
  std::unique_lock lock(mutex_);
  lost_.reset();
  lock.unlock();
  host().log("The microphone works again.");
  host().available(true);
}

PluginFactory alsa_microphone_factory(const StreamLimits& limits) {
  PluginDescription description;
  description.name = "AlsaMicrophone";
  description.roles = {"Microphone"};
  description.sentence = "a microphone of this machine, over ALSA";
  description.options = option_descriptions();
  return {std::move(description),
          [limits] { return std::make_unique<AlsaMicrophone>(limits); }};
}

} // namespace parlour::adapters
