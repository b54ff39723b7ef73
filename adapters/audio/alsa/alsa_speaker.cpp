#include "adapters/audio/alsa/alsa_speaker.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace parlour::adapters {

namespace {

// How long the device goes on in silence, so that the next utterance need not
// start it again.
constexpr Milliseconds linger{500};

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> options = {
      {"device", "default", "the device, as ALSA knows it, such as hw:1"}};
  return options;
}

} // namespace

AlsaSpeaker::AlsaSpeaker(StreamLimits limits) : limits_(limits) {}

AlsaSpeaker::~AlsaSpeaker() {
  stream_.reset();
}

Expected<void> AlsaSpeaker::on_start(const Options& options) {
  WantedDevice wanted;
  wanted.name = option_value(options, option_descriptions(), "device");
  wanted.direction = SoundDirection::playback;
  silent_ = linger;
  return DeviceStream::start(wanted, limits_, *this).map([&](auto stream) {
    stream_ = std::move(stream);
  });
}

void AlsaSpeaker::stop() {
  if (stream_ && !stream_->stop())
    host().log("The speaker's driver hangs; its thread is left to itself.");
  stream_.reset();
}

Expected<void> AlsaSpeaker::ready() {
  if (lost_)
    return fail(ErrorKind::offline, *lost_);
  return {};
}

void AlsaSpeaker::changed() {
  stream_->wake();
}

// -- on the stream's thread
// ----------------------------------------------------

bool AlsaSpeaker::is_running() {
  return silent_ < linger ||
         with_playout([](Playout& playout) { return playout.has_work(); });
}

// A rate that cannot be converted is that of no sound device.
void AlsaSpeaker::begin(const PcmFormat& format) {
  format_ = format;
  resampler_.reset();
  if (auto made = Resampler::create({}, format))
    resampler_ = std::move(*made);
  else
    host().failed(made.error().message);
}

void AlsaSpeaker::fill(std::vector<Sample>& samples) {
  if (!resampler_)
    return;
  std::array<Sample, frame_samples / 2> half{};
  auto playing = with_playout([&](Playout& playout) {
    return playout.pull(half) > 0 ? std::optional(playout.playing(half))
                                  : std::nullopt;
  });
  silent_ = playing ? Milliseconds::zero()
                    : std::min(linger, silent_ + Milliseconds(frame_time / 2));
  resampler_->process(half, samples);
  add_playing(half, std::move(playing));
}

void AlsaSpeaker::add_playing(std::span<const Sample> samples,
                              std::optional<PlayoutEvent> event) {
  sounding_.insert(sounding_.end(), samples.begin(), samples.end());
  if (event && !playing_)
    playing_ = std::move(event);
  if (sounding_.size() < frame_samples)
    return;
  if (auto whole = std::exchange(playing_, std::nullopt)) {
    whole->params.front() = pcm_value(sounding_);
    tell({*whole});
  }
  sounding_.clear();
}

void AlsaSpeaker::waiting(std::size_t samples) {
  const auto frames = samples / static_cast<std::size_t>(format_.channels);
  const auto behind =
      frames * speech_rate / static_cast<std::size_t>(format_.rate);
  tell(with_playout([&](Playout& playout) {
    const auto heard = playout.pulled() - std::min(playout.pulled(), behind);
    heard_ = std::max(heard_, heard);
    return playout.events(heard_);
  }));
}

void AlsaSpeaker::lost(const std::string& reason) {
  host().log(reason);
  tell(with_playout([&](Playout& playout) {
    lost_ = reason;
    return playout.abandon(heard_);
  }));
  answer({}, "Failed", {reason});
  host().available(false);
}

void AlsaSpeaker::found() {
  with_playout([&](Playout&) { lost_.reset(); });
  host().log("The speaker works again.");
  host().available(true);
}

PluginFactory alsa_speaker_factory(const StreamLimits& limits) {
  PluginDescription description;
  description.name = "AlsaSpeaker";
  description.roles = {"Speaker"};
  description.sentence = "a speaker of this machine, over ALSA";
  description.options = option_descriptions();
  return {std::move(description),
          [limits] { return std::make_unique<AlsaSpeaker>(limits); }};
}

} // namespace parlour::adapters
