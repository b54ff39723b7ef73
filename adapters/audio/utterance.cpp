#include "adapters/audio/utterance.hpp"

#include <algorithm>
#include <utility>

namespace parlour::adapters {

Utterance::Utterance(Message order, std::int64_t id)
    : order_(std::move(order)), id_(id) {}

void Utterance::append(const Value& audio, std::span<const Sample> samples) {
  if (samples.empty())
    return;
  pieces_.push_back({audio, samples});
  waiting_ += samples.size();
}

// Marks come in order, so the place is nearly always the end.
void Utterance::mark(std::string word, std::int64_t position) {
  const auto place =
      std::ranges::upper_bound(marks_, position, {}, &Mark::position);
  marks_.insert(place, {std::move(word), position});
}

void Utterance::finish(Message order) {
  order_ = std::move(order);
  finished_ = true;
}

// What has not begun to sound needs no fading.
void Utterance::stop() {
  if (!is_stopped())
    fade_left_ = taken_ == 0 ? 0 : fade_samples;
}

bool Utterance::is_over() const {
  if (is_stopped())
    return *fade_left_ == 0 || waiting_ == 0;
  return finished_ && waiting_ == 0;
}

std::size_t Utterance::take(std::span<Sample> out) {
  if (is_stopped())
    out = out.first(std::min(out.size(), *fade_left_));
  std::size_t done = 0;
  while (done < out.size() && !pieces_.empty()) {
    auto& rest = pieces_.front().rest;
    const auto count = std::min(rest.size(), out.size() - done);
    std::ranges::copy(rest.first(count), out.subspan(done).begin());
    rest = rest.subspan(count);
    done += count;
    if (rest.empty())
      pieces_.pop_front();
  }
  waiting_ -= done;
  taken_ += done;
  if (is_stopped())
    fade(out.first(done));
  return done;
}

void Utterance::fade(std::span<Sample> samples) {
  for (auto& sample : samples)
    sample = static_cast<Sample>(sample * static_cast<int>((*fade_left_)--) /
                                 int{fade_samples});
}

// A word ends where the next begins, the last one with the utterance.
Value Utterance::spoken_text(std::size_t heard) const {
  if (marks_.empty())
    return {};
  const bool whole = finished_ && heard == taken_ && waiting_ == 0;
  std::string text;
  for (auto word = marks_.begin(); word != marks_.end(); ++word) {
    const auto next = word + 1;
    if (!whole && (next == marks_.end() || next->position > duration(heard)))
      break;
    text += (text.empty() ? "" : " ") + word->word;
  }
  return text;
}

} // namespace parlour::adapters
