// ProbabilityDetector: from how likely each piece of a stream is speech to
// where speech begins and ends. Pure; not thread-safe.
#pragma once

#include <cstdint>
#include <optional>

#include "adapters/vad/speech_detector.hpp"

namespace parlour::adapters {

class ProbabilityDetector {
public:
  // Of a piece, in ms.
  static constexpr std::int64_t piece = 32;

  // `hangover`: a stream without speech for so long has ended; in ms.
  explicit ProbabilityDetector(int hangover) : hangover_(hangover) {}

  // The next piece, which begins at this position.
  std::optional<SpeechEdge> take(double likely, std::int64_t position);
  // The stream ends here: so does speech that is open.
  std::optional<SpeechEdge> finish();

private:
  bool is_speech(double likely) const;

  int hangover_;
  bool in_speech_ = false;
  int pieces_ = 0;         // of speech in a row, before it begins
  std::int64_t first_ = 0; // where the first of them begins
  std::int64_t last_ = 0;  // where the last piece of speech ends
};

} // namespace parlour::adapters
