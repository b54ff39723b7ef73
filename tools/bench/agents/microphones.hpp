// The row `audio` of `parlour bench agents`: microphones that send without a
// pause, each of them an agent.
#pragma once

#include <iosfwd>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// Prints how long the audio took at the beginning and at the end. False if it
// could not be measured.
bool audio_row(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
