// The rows of `parlour bench speech` that hold all conversations of an
// application by voice, two at a time.
#pragma once

#include <iosfwd>
#include <string>

#include "tools/parlour/voice_test/voice_suite.hpp"

namespace parlour::tools {

struct ConversationRow {
  std::string name;
  NoiseWish noise;
  double word_errors; // bars, in percent
  double understood;
};

// Of rows that are answered by what is said most often: the share that would be
// right, in percent.
double always_the_same(const std::vector<VoiceResult>& results);

// Time from the decision that a turn is over to the robot's first sound, beyond
// what is waited for.
Milliseconds reaction(const std::vector<Latency>& latencies, int percent);

// Prints a line for each voice.
void print_conversations(const ConversationRow& row, const VoiceWish& wish,
                         const std::vector<VoiceResult>& results,
                         std::ostream& out);

} // namespace parlour::tools
