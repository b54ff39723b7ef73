// SileroStream: one stream of audio whose pieces a program judges elsewhere.
// Not thread-safe.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "adapters/vad/echo_gauge.hpp"
#include "adapters/vad/probability_detector.hpp"
#include "adapters/vad/speech_detector.hpp"

namespace parlour::adapters {

class SileroStream {
public:
  SileroStream(int hangover, double echo_loss, std::int64_t position)
      : detector_(hangover), echo_(echo_loss), begin_(position) {}

  // Whether audio at this position follows; positions may be rounded.
  bool follows(std::int64_t position) const;
  std::int64_t end() const {
    return begin_ + duration(samples_);
  }
  // Goes on with what another stream has learned of the echo.
  void continue_echo(const SileroStream& other) {
    echo_ = other.echo_;
    echo_meter_ = other.echo_meter_;
  }

  // Audio that the program gets, too.
  void hear(std::span<const Sample> audio);
  void hear_echo(std::span<const Sample> audio);
  // What the program says of the pieces that are complete.
  std::vector<SpeechEdge> judged(const std::vector<double>& likely);
  std::vector<SpeechEdge> finish();

private:
  struct Heard {
    std::int64_t end = 0; // of the audio
    bool is_echo = false;
  };

  bool is_echo(std::int64_t begin, std::int64_t end);

  ProbabilityDetector detector_;
  EchoGauge echo_;
  SpeechBandMeter meter_;
  SpeechBandMeter echo_meter_;
  std::int64_t begin_ = 0;
  std::size_t samples_ = 0; // heard
  std::int64_t pieces_ = 0; // judged
  std::deque<Heard> heard_; // and not judged
};

} // namespace parlour::adapters
