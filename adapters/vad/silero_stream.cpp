#include "adapters/vad/silero_stream.hpp"

#include <algorithm>
#include <cstdlib>

namespace parlour::adapters {

namespace {

// A program that is not ready for so long fails anyway.
constexpr std::size_t most_heard = 60'000 / frame_time;

} // namespace

bool SileroStream::follows(std::int64_t position) const {
  return std::abs(position - end()) <= 2;
}

void SileroStream::hear(std::span<const Sample> audio) {
  const auto level = meter_.level(audio);
  echo_.hears(level);
  samples_ += audio.size();
  heard_.push_back({end(), level < echo_.most_of(echo_.played())});
  if (heard_.size() > most_heard)
    heard_.pop_front();
}

void SileroStream::hear_echo(std::span<const Sample> audio) {
  echo_.plays(echo_meter_.level(audio));
}

// A piece is only echo if all of it is.
bool SileroStream::is_echo(std::int64_t begin, std::int64_t end) {
  while (!heard_.empty() && heard_.front().end <= begin)
    heard_.pop_front();
  bool all = !heard_.empty();
  for (const auto& one : heard_) {
    all &= one.is_echo;
    if (one.end >= end)
      break;
  }
  return all;
}

std::vector<SpeechEdge>
SileroStream::judged(const std::vector<double>& likely) {
  std::vector<SpeechEdge> edges;
  for (const auto one : likely) {
    const auto begin = begin_ + pieces_ * ProbabilityDetector::piece;
    ++pieces_;
    const auto drowned = is_echo(begin, begin + ProbabilityDetector::piece);
    if (const auto edge = detector_.take(drowned ? 0 : one, begin))
      edges.push_back(*edge);
  }
  return edges;
}

std::vector<SpeechEdge> SileroStream::finish() {
  const auto edge = detector_.finish();
  return edge ? std::vector{*edge} : std::vector<SpeechEdge>();
}

} // namespace parlour::adapters
