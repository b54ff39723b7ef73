// What a detector of speech does, whatever it listens for: the plug-ins of the
// role VAD differ only in the detector.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

// Where speech begins or ends, in ms since the stream's beginning.
struct SpeechEdge {
  bool begins = false;
  std::int64_t position = 0;

  bool operator==(const SpeechEdge&) const = default;
};

// One stream of audio. For one thread at a time.
class SpeechDetector {
public:
  virtual ~SpeechDetector() = default;

  // Takes the next audio, of any length. `position` is that of its first
  // sample, in ms; without it, the audio follows what came before. A position
  // that does not follow is believed: speech that was open ends at the gap.
  virtual std::vector<SpeechEdge>
  take(std::span<const Sample> audio,
       std::optional<std::int64_t> position = {}) = 0;

  // What plays now.
  virtual void hear_echo(std::span<const Sample> audio) = 0;

  // The next audio has nothing to do with what came before; positions begin at
  // 0.
  virtual void reset() = 0;
};

} // namespace parlour::adapters
