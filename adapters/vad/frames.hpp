// Cuts a stream of audio into frames of 20 ms and keeps count of positions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <span>
#include <vector>

#include "adapters/audio/pcm.hpp"

namespace parlour::adapters {

class Frames {
public:
  // Calls `gap` if the audio does not follow what came before, then `frame`
  // with each frame that is complete; position() is then that of its end.
  template <class Gap, class Frame>
  void take(std::span<const Sample> audio, std::optional<std::int64_t> position,
            Gap gap, Frame frame) {
    if (position && !follows(*position)) {
      gap();
      part_.clear();
      position_ = *position;
    }
    while (!audio.empty()) {
      const auto count = std::min(frame_samples - part_.size(), audio.size());
      part_.insert(part_.end(), audio.begin(),
                   audio.begin() + static_cast<std::ptrdiff_t>(count));
      audio = audio.subspan(count);
      if (part_.size() < frame_samples)
        return;
      position_ += frame_time;
      frame(std::span<const Sample>(part_));
      part_.clear();
    }
  }

  // Of the end of the last complete frame, in ms.
  std::int64_t position() const {
    return position_;
  }
  std::int64_t position_before(std::size_t frames) const {
    return position_ - static_cast<std::int64_t>(frames) * frame_time;
  }

private:
  // Positions may be rounded.
  bool follows(std::int64_t position) const {
    return std::abs(position - position_ - duration(part_.size())) <= 2;
  }

  // A frame that is not complete yet.
  std::vector<Sample> part_;
  std::int64_t position_ = 0;
};

} // namespace parlour::adapters
