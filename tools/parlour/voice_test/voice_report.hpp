// Prints what came of conversations by voice, for people (docs/speech.md).
#pragma once

#include <iosfwd>
#include <vector>

#include "tools/parlour/voice_test/voice_suite.hpp"

namespace parlour::tools {

// Each row that was not understood or not answered as by text, and each
// conversation that was not held. `all`: every row, and what its time went to.
void print_rows(std::ostream& out, const std::vector<VoiceResult>& results,
                bool all);

// A table with a line for each voice.
void print_scores(std::ostream& out, const std::vector<VoiceResult>& results,
                  const VoiceWish& wish);

// Whether all that was held went as by text, and something was held.
bool all_as_by_text(const std::vector<VoiceResult>& results);

} // namespace parlour::tools
