// EchoGauge: how loud a microphone hears what the loudspeaker plays. Nobody
// knows that beforehand: in a headset, behind an echo canceller or with files
// it is nothing, on a table it is much. So it is learned: of several pieces of
// what plays, the one in which the microphone heard least tells most, because
// in the others somebody may have spoken.
//
// Levels are in dB of full scale, of pieces of 20 ms. For one thread at a time.
#pragma once

#include <deque>

#include "adapters/vad/level.hpp"

namespace parlour::adapters {

class EchoGauge {
public:
  // Until it is learned, the echo is at most what plays, less `loss` dB.
  explicit EchoGauge(double loss);

  // What plays now.
  void plays(double level);
  // The next frame of the microphone.
  void hears(double level);

  // The loudest of what played just now and may sound in the microphone still,
  // and of what plays this very moment; lowest_level if there is none.
  double played() const {
    return left_ > 0 ? loudest_ : lowest_level;
  }
  double playing() const;

  // How loud the echo of what played at this level usually is, and what it
  // never exceeds.
  double echo_of(double played) const;
  // Whether it was learned that nothing to speak of comes back.
  bool is_silent() const;
  double most_of(double played) const;

private:
  void learn(double level);

  double next_ = lowest_level;    // since the last frame
  std::deque<double> recent_;     // of the last frames, the latest last
  double loudest_ = lowest_level; // of them; falls slowly
  int left_ = 0;                  // for so many frames an echo may sound
  std::deque<double> window_;     // what was heard above what played
  std::deque<double> windows_;    // the loudest of each
  double coupling_ = 0;           // the least of them
};

} // namespace parlour::adapters
