// Spoken: what has come so far of a text that a component of the role TTS
// speaks.
#pragma once

#include <string>
#include <vector>

#include "adapters/audio/pcm.hpp"
#include "runtime/message/message.hpp"

namespace parlour::tools {

struct Spoken {
  std::vector<adapters::Sample> samples;
  bool finished = false;
  std::string trouble; // why it is not spoken; empty: it is

  bool is_over() const {
    return finished || !trouble.empty();
  }
  // Takes an event of the component.
  void take(const Message& event);
};

} // namespace parlour::tools
