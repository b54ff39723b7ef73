// The row of `parlour bench speech` for what a recogniser takes.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/voice_test/speech_bank.hpp"

namespace parlour::tools {

// Starts the chain and says these lines to it: memory, the time until the first
// is recognised, and CPU time of what is spoken. To be measured before other
// rows, whose memory would hide it.
bool load_row(const Application& spoken, SpeechBank& bank, bool told,
              const std::vector<std::string>& lines, const std::string& voice,
              std::ostream& out);

} // namespace parlour::tools
