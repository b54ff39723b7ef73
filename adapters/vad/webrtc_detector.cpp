#include "adapters/vad/webrtc_detector.hpp"

#include <algorithm>
#include <bitset>
#include <utility>

#include <webrtc/modules/audio_processing/include/audio_processing.h>
#include <webrtc/modules/interface/module_common_types.h>

#include "adapters/vad/echo_gauge.hpp"
#include "adapters/vad/frames.hpp"
#include "adapters/vad/level.hpp"

namespace parlour::adapters {

namespace {

constexpr std::size_t half_frame = frame_samples / 2; // 10 ms
// Of the last frames so many must be voiced when speech begins.
constexpr std::size_t onset_frames = 8;
constexpr std::size_t onset_voiced = 5;

class WebRtcDetector : public SpeechDetector {
public:
  explicit WebRtcDetector(const WebRtcDetectorSettings& settings)
      : settings_(settings), echo_(settings.echo_loss) {
    WebRtcDetector::reset();
  }

  std::vector<SpeechEdge> take(std::span<const Sample> audio,
                               std::optional<std::int64_t> position) override {
    stream_.take(
        audio, position, [&] { end_at_gap(); },
        [&](std::span<const Sample> frame) { take_frame(frame); });
    return std::exchange(found_, {});
  }

  void hear_echo(std::span<const Sample> audio) override {
    echo_.plays(echo_meter_.level(audio));
  }

  void reset() override {
    processing_.reset(webrtc::AudioProcessing::Create());
    auto* const detection = processing_->voice_detection();
    detection->Enable(true);
    // From the one that misses least to the one that is mistaken least.
    using webrtc::VoiceDetection;
    constexpr VoiceDetection::Likelihood likelihoods[] = {
        VoiceDetection::kHighLikelihood, VoiceDetection::kModerateLikelihood,
        VoiceDetection::kLowLikelihood, VoiceDetection::kVeryLowLikelihood};
    detection->set_likelihood(likelihoods[settings_.strictness]);
    stream_ = {};
    voiced_.reset();
    in_speech_ = false;
    silent_frames_ = 0;
    echo_ = EchoGauge(settings_.echo_loss);
  }

private:
  // Half of a frame is 10 ms, which is what the library takes.
  bool is_voiced(std::span<const Sample> frame) {
    bool voiced = false;
    for (const auto half : {frame.first(half_frame), frame.last(half_frame)}) {
      webrtc::AudioFrame given;
      given.sample_rate_hz_ = speech_rate;
      given.num_channels_ = 1;
      given.samples_per_channel_ = half_frame;
      std::ranges::copy(half, given.data_);
      if (processing_->ProcessStream(&given) ==
          webrtc::AudioProcessing::kNoError)
        voiced |= processing_->voice_detection()->stream_has_voice();
    }
    return voiced;
  }

  void take_frame(std::span<const Sample> frame) {
    const auto level = meter_.level(frame);
    echo_.hears(level);
    const bool drowned = level < echo_.most_of(echo_.played());
    const bool voiced = is_voiced(frame) && !drowned;
    voiced_ = voiced_ << 1;
    voiced_[0] = voiced;
    silent_frames_ = voiced ? 0 : silent_frames_ + 1;
    if (in_speech_)
      end_if_silent();
    else if (voiced_.count() >= onset_voiced)
      begin();
  }

  void begin() {
    auto first = onset_frames - 1;
    while (!voiced_[first])
      --first;
    in_speech_ = true;
    found_.push_back({true, stream_.position_before(first + 1)});
  }

  void end_if_silent() {
    if (silent_frames_ * frame_time >=
        static_cast<std::size_t>(settings_.hangover))
      end_at_gap();
  }

  void end_at_gap() {
    if (in_speech_)
      found_.push_back({false, stream_.position_before(silent_frames_)});
    in_speech_ = false;
    voiced_.reset();
  }

  WebRtcDetectorSettings settings_;
  std::unique_ptr<webrtc::AudioProcessing> processing_;
  Frames stream_;
  SpeechBandMeter meter_;
  SpeechBandMeter echo_meter_;
  EchoGauge echo_;
  // The latest frame is bit 0.
  std::bitset<onset_frames> voiced_;
  bool in_speech_ = false;
  std::size_t silent_frames_ = 0;
  std::vector<SpeechEdge> found_;
};

} // namespace

Expected<std::unique_ptr<SpeechDetector>>
make_webrtc_detector(const WebRtcDetectorSettings& settings) {
  return std::make_unique<WebRtcDetector>(settings);
}

} // namespace parlour::adapters
