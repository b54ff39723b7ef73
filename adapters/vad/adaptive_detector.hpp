// AdaptiveDetector finds where speech begins and ends in a stream of audio by
// its level. The threshold lies between the noise (the 20th percentile of the
// last four seconds) and a peak of speech that decays, so that it follows rooms
// and distances without settings. Pure; not thread-safe.
//
// A frame of 20 ms is voiced if it is above the threshold. Speech begins when
// most frames of a short while are voiced, and ends when none was for the
// hangover. The positions are those at which speech really began and ended:
// its weak first and last sounds are looked up in the levels kept. Where the
// robot's own voice hid the first words of somebody who interrupts it, they are
// looked up in the last second.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"
#include "adapters/vad/echo_gauge.hpp"
#include "adapters/vad/frames.hpp"
#include "adapters/vad/level.hpp"
#include "adapters/vad/speech_detector.hpp"

namespace parlour::adapters {

class AdaptiveDetector : public SpeechDetector {
public:
  struct Settings {
    // A stream without voiced frames for so long has ended; in ms.
    int hangover = 200;
    // Of this many frames, so many must be voiced when speech begins.
    int onset_frames = 8;
    int onset_voiced = 5;
    // So much above the threshold must be the loudest two of them, in dB: the
    // loudest syllables of a crowd are not.
    double onset_strength = 3;
    // Speech is so much above the noise, in dB: more where the noise itself
    // goes up and down, and never more than the last.
    double least_margin = 4.5;
    double margin_of_spread = 2.5; // times the noise's spread, beside 2 dB
    double most_least = 8;
    double most_margin = 22;
    // The threshold's place between noise (0) and peak (1).
    double between = 0.4;
    // Who speaks to the robot is hardly ever so much softer than the peak, in
    // dB; other people behind are. Never beyond the margin above.
    double most_below_peak = 15;
    // Nothing below is speech, in dB of full scale.
    double least_level = -55;
    // What the microphone hears of what plays is weaker by so much, in dB,
    // until it is learned how much it really hears.
    double echo_loss = 10;
  };

  AdaptiveDetector() : AdaptiveDetector(Settings()) {}
  explicit AdaptiveDetector(const Settings& settings);

  std::vector<SpeechEdge>
  take(std::span<const Sample> audio,
       std::optional<std::int64_t> position = {}) override;
  // What plays raises the threshold for a moment, by as much as the microphone
  // hears of it.
  void hear_echo(std::span<const Sample> audio) override;
  void reset() override;

  // In dB of full scale.
  double threshold() const;

private:
  struct Frame {
    double level = 0;
    double played = lowest_level; // what may sound in it of the loudspeaker
    bool voiced = false;
  };

  void take_frame(std::span<const Sample> frame);
  void follow(double level);
  double percentile(double which) const;
  double noise() const;
  double least_margin() const;
  double weakest_of_speech() const;
  double threshold_without_echo() const;
  void begin_if_voiced();
  void end_if_silent();
  std::size_t onset_size() const;
  std::size_t first_of_speech() const;
  std::size_t first_beside_echo(std::size_t at) const;
  void end_at_gap();

  Settings settings_;
  SpeechBandMeter meter_;
  SpeechBandMeter echo_meter_;
  Frames stream_;
  // Of the last frames, the latest last; bounded by four seconds.
  std::deque<Frame> frames_;
  // The same levels, sorted.
  std::vector<double> sorted_;
  double peak_ = 0;
  EchoGauge echo_;
  bool in_speech_ = false;
  std::size_t silent_frames_ = 0;
  std::vector<SpeechEdge> found_;
};

} // namespace parlour::adapters
