#include "adapters/vad/probability_detector.hpp"

#include <utility>

namespace parlour::adapters {

namespace {

// As the makers of Silero advise: more is needed to begin than to go on.
constexpr double begins = 0.5;
constexpr double goes_on = 0.35;
// A knock is shorter.
constexpr int least_pieces = 3;

} // namespace

bool ProbabilityDetector::is_speech(double likely) const {
  return likely >= (in_speech_ ? goes_on : begins);
}

std::optional<SpeechEdge> ProbabilityDetector::take(double likely,
                                                    std::int64_t position) {
  if (is_speech(likely)) {
    last_ = position + piece;
    if (in_speech_)
      return {};
    if (pieces_++ == 0)
      first_ = position;
    if (pieces_ < least_pieces)
      return {};
    in_speech_ = true;
    return SpeechEdge{true, first_};
  }
  pieces_ = 0;
  if (in_speech_ && position + piece - last_ >= hangover_)
    return finish();
  return {};
}

std::optional<SpeechEdge> ProbabilityDetector::finish() {
  pieces_ = 0;
  if (!std::exchange(in_speech_, false))
    return {};
  return SpeechEdge{false, last_};
}

} // namespace parlour::adapters
