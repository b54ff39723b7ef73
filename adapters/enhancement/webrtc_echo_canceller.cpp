#include <algorithm>
#include <utility>

#include <webrtc/modules/audio_processing/include/audio_processing.h>
#include <webrtc/modules/interface/module_common_types.h>

#include "adapters/enhancement/echo_canceller.hpp"
#include "adapters/vad/echo_gauge.hpp"
#include "adapters/vad/level.hpp"

namespace parlour::adapters {

namespace {

constexpr std::size_t piece = frame_samples / 2; // 10 ms
// An echo is over so long after the last sound was played, in pieces: the
// room's and the devices' delay.
constexpr int echo_lasts = 100;

void fill(webrtc::AudioFrame& frame, std::span<const Sample> samples) {
  frame.sample_rate_hz_ = speech_rate;
  frame.num_channels_ = 1;
  frame.samples_per_channel_ = piece;
  std::ranges::copy(samples, frame.data_);
}

} // namespace

struct EchoCanceller::Implementation {
  std::unique_ptr<webrtc::AudioProcessing> processing;
  int delay = 0;
  // Whether anything is to be done while nothing plays.
  bool always = false;
  int echo_pieces = 0;
  std::vector<Sample> playing; // less than a piece
  // Where no echo is heard, as in a headset, taking it out would only take
  // something of the user's voice.
  EchoGauge echo{0};
  SpeechBandMeter heard_meter;
  SpeechBandMeter played_meter;

  void process(std::span<Sample> samples) {
    if (echo_pieces == 0 && !always)
      return;
    echo_pieces = std::max(0, echo_pieces - 1);
    webrtc::AudioFrame frame;
    fill(frame, samples);
    processing->set_stream_delay_ms(delay);
    const auto done = processing->ProcessStream(&frame);
    if (done == webrtc::AudioProcessing::kNoError &&
        (always || !echo.is_silent()))
      std::ranges::copy(std::span(frame.data_, samples.size()),
                        samples.begin());
  }
};

Expected<EchoCanceller> EchoCanceller::make(const Settings& settings) {
  auto made = std::make_unique<Implementation>();
  webrtc::Config config;
  config.Set<webrtc::DelayAgnostic>(new webrtc::DelayAgnostic(true));
  config.Set<webrtc::ExtendedFilter>(new webrtc::ExtendedFilter(true));
  made->processing.reset(webrtc::AudioProcessing::Create(config));
  auto& processing = *made->processing;
  processing.echo_cancellation()->Enable(true);
  processing.echo_cancellation()->set_suppression_level(
      webrtc::EchoCancellation::kHighSuppression);
  processing.high_pass_filter()->Enable(settings.noise_suppression);
  processing.noise_suppression()->Enable(settings.noise_suppression);
  processing.gain_control()->set_mode(webrtc::GainControl::kAdaptiveDigital);
  processing.gain_control()->Enable(settings.gain_control);
  made->delay = settings.delay;
  made->always = settings.noise_suppression || settings.gain_control;
  return EchoCanceller(std::move(made));
}

EchoCanceller::EchoCanceller(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

EchoCanceller::EchoCanceller(EchoCanceller&&) noexcept = default;
EchoCanceller& EchoCanceller::operator=(EchoCanceller&&) noexcept = default;
EchoCanceller::~EchoCanceller() = default;

void EchoCanceller::played(std::span<const Sample> audio) {
  implementation_->echo.plays(implementation_->played_meter.level(audio));
  auto& playing = implementation_->playing;
  playing.insert(playing.end(), audio.begin(), audio.end());
  std::size_t at = 0;
  for (; at + piece <= playing.size(); at += piece) {
    webrtc::AudioFrame frame;
    fill(frame, std::span(playing).subspan(at, piece));
    implementation_->processing->ProcessReverseStream(&frame);
  }
  playing.erase(playing.begin(),
                playing.begin() + static_cast<std::ptrdiff_t>(at));
  implementation_->echo_pieces = echo_lasts;
}

std::vector<Sample> EchoCanceller::heard(std::span<const Sample> audio) {
  implementation_->echo.hears(implementation_->heard_meter.level(audio));
  std::vector<Sample> enhanced(audio.begin(), audio.end());
  for (std::size_t at = 0; at + piece <= enhanced.size(); at += piece)
    implementation_->process(std::span(enhanced).subspan(at, piece));
  return enhanced;
}

} // namespace parlour::adapters
