#include "tools/bench/speech/segments.hpp"

#include <algorithm>
#include <cstdlib>

#include "adapters/audio/mixing.hpp"

namespace parlour::tools {

namespace {

using adapters::frame_samples;
using adapters::frame_time;

constexpr std::int64_t hangover = 300;

bool overlap(const Segment& one, const Segment& other) {
  return one.begin < other.end && other.begin < one.end;
}

} // namespace

SegmentScore compare_segments(const std::vector<Segment>& said,
                              const std::vector<Segment>& found) {
  SegmentScore score;
  score.said = said.size();
  const Segment* before = nullptr; // found for the line before
  for (const auto& line : said) {
    const auto match = std::ranges::find_if(
        found, [&](const auto& each) { return overlap(line, each); });
    if (match == found.end())
      ++score.missed;
    else if (&*match == before)
      ++score.merged;
    else
      score.delays.push_back(std::abs(match->begin - line.begin));
    before = match == found.end() ? nullptr : &*match;
  }
  for (const auto& each : found)
    score.false_alarms += std::ranges::none_of(
        said, [&](const auto& line) { return overlap(line, each); });
  std::ranges::sort(score.delays);
  return score;
}

std::vector<Segment> by_fixed_level(std::span<const adapters::Sample> sound,
                                    double level) {
  std::vector<Segment> found;
  std::int64_t now = 0;
  for (std::size_t at = 0; at + frame_samples <= sound.size();
       at += frame_samples, now += frame_time) {
    if (adapters::level_of(sound.subspan(at, frame_samples)) <= level)
      continue;
    if (found.empty() || found.back().end < now)
      found.push_back({now, 0});
    found.back().end = now + frame_time + hangover;
  }
  return found;
}

} // namespace parlour::tools
