// The row of `parlour bench speech` for the detector.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/speech/segments.hpp"
#include "tools/parlour/application/application.hpp"
#include "tools/parlour/voice_test/background.hpp"

namespace parlour::tools {

// Lines with pauses between them, and where they are.
struct SpokenRow {
  adapters::Sound sound;
  std::vector<Segment> said;
};
// The lines in this noise, with pauses of 1.2 s.
SpokenRow in_a_row(const std::vector<const adapters::Sound*>& lines,
                   const adapters::Sound& noise);

// 60 lines in babble at 10 dB, by the application's detector.
bool detector_row(const Application& spoken, SpeechBank& bank,
                  const std::vector<std::string>& lines,
                  const std::string& voice, std::ostream& out);

} // namespace parlour::tools
