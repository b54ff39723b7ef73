// How fast sound in files is played and heard: the option `pace` and the
// moments that follow from it.
#pragma once

#include "adapters/audio/pcm.hpp"
#include "runtime/base/clock.hpp"
#include "runtime/plugin/options.hpp"

namespace parlour::adapters {

// The option's description: `what` is done faster.
OptionDescription pace_option(const std::string& what);

// The moments of the frames of a stream. For one thread at a time.
class Pace {
public:
  // How many frames may follow each other at one moment if there were delays.
  static constexpr std::int64_t most_late = 50;

  // `text` is the option's value: 1 is the pace of the clock, 10 is ten times
  // faster, 0 as fast as components may fire events. Errors are of kind
  // Settings.
  static Expected<Pace> read(const std::string& text);
  static Pace of_clock() {
    return Pace(1);
  }

  // The stream begins now. Its first frame is complete, or due, after its time.
  void begin(Timestamp now);
  // The frame that was due is done.
  void next();
  // What is more than `most_late` frames late is not caught up: the rest of the
  // stream moves. Returns how long it is until the next frame; zero if it is
  // due.
  Milliseconds until_next(Timestamp now);
  // How much sound passes in so much time of the clock.
  Milliseconds sound_in(Milliseconds time) const;

private:
  explicit Pace(double factor) : factor_(factor) {}

  Timestamp due() const;

  double factor_;
  Timestamp begin_ = 0;
  std::int64_t done_ = 0; // frames since then
};

} // namespace parlour::adapters
