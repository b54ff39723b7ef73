// NoiseGate makes the pauses of an utterance silent, before it, behind it and
// within: a recogniser hears words in the babble of a room. The noise is what
// the utterance begins with, since an endpointer passes on a little of what was
// before the speech. Pure; not thread-safe.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters::asr {

// Made anew for each utterance.
class NoiseGate {
public:
  // Takes the next audio of the utterance, and returns what can be decided:
  // what comes first is kept for 250 ms, the rest for 60 ms.
  std::vector<Sample> take(std::span<const Sample> audio);
  // The rest; the next audio begins another utterance.
  std::vector<Sample> finish();

private:
  struct Frame {
    std::vector<Sample> samples;
    double level = 0; // dB of full scale
  };

  void add_frame();
  void learn_noise();
  bool is_open() const;
  void pass(std::vector<Sample>& to);

  std::vector<Sample> part_; // a frame that is not complete yet
  std::deque<Frame> kept_;
  std::optional<double> noise_;    // once it is known, in dB
  std::size_t since_loud_ = 1'000; // frames that were passed
  double gain_ = 1;
};

} // namespace parlour::adapters::asr
