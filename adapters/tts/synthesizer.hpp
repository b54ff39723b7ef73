// Synthesizer: what a library for speech has to do. A SpeechEngine owns it and
// calls it on its thread only.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "adapters/audio/pcm.hpp"
#include "adapters/tts/spoken_text.hpp"
#include "runtime/base/error.hpp"

namespace parlour::adapters::tts {

struct VoiceSettings {
  std::string voice;
  int rate = 175;   // words a minute, 80 to 450; 175 is the library's own pace
  int pitch = 50;   // 0 to 99; 50 is the voice's own
  int volume = 100; // in percent, 0 to 200

  bool operator==(const VoiceSettings&) const = default;
};

// Gets what is synthesized, in order.
class SpeechSink {
public:
  virtual ~SpeechSink() = default;

  // The word of this index begins at this position, in ms since the piece
  // began. Words may come again and out of order; the first time counts.
  virtual void word(std::size_t index, std::int64_t position) = 0;
  // More sound of one channel. The rate, in samples a second, stays the same.
  // False: the rest is not wanted, and speak() is to return.
  virtual bool sound(std::span<const Sample> samples, int rate) = 0;
  // For those who wait long for sound: whether sound() would return true.
  virtual bool is_wanted() const = 0;
};

class Synthesizer {
public:
  virtual ~Synthesizer() = default;

  virtual PieceLength piece_length() const = 0;
  // An error of kind Settings if there is no such voice. It says which there
  // are.
  virtual Expected<void> check_voice(const std::string& voice) = 0;
  // Speaks one piece. `is_last`: nothing of the text follows, so no pause is
  // needed.
  virtual Expected<void> speak(const Words& piece, bool is_last,
                               const VoiceSettings& settings,
                               SpeechSink& sink) = 0;
};

} // namespace parlour::adapters::tts
