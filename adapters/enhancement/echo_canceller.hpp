// EchoCanceller takes out of what a microphone hears what the loudspeaker
// plays, and on request noise; by libwebrtc-audio-processing. One stream; for
// one thread at a time.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters {

class EchoCanceller {
public:
  struct Settings {
    bool noise_suppression = false;
    bool gain_control = false;
    // The least time from playing to hearing, in ms; 0 to 500. More is found by
    // itself.
    int delay = 0;
  };

  // An error if the program was built without the library.
  static Expected<EchoCanceller> make(const Settings& settings);

  EchoCanceller(EchoCanceller&&) noexcept;
  EchoCanceller& operator=(EchoCanceller&&) noexcept;
  ~EchoCanceller();

  // What plays now; before the heard() of the same moment. It is kept back to
  // frames of 10 ms.
  void played(std::span<const Sample> audio);

  // Returns the same audio enhanced. What does not fill frames of 10 ms stays
  // as it is. Cancelling begins with played(), and ends some time after it.
  std::vector<Sample> heard(std::span<const Sample> audio);

private:
  struct Implementation;

  explicit EchoCanceller(std::unique_ptr<Implementation> implementation);

  std::unique_ptr<Implementation> implementation_;
};

} // namespace parlour::adapters
