// What was heard in a sound file, and what the understanding makes of it, for
// people and for programs.
#pragma once

#include <string>
#include <vector>

#include "tools/parlour/speech/ears.hpp"

namespace parlour::tools {

// What the understanding makes of a turn's text.
struct UnderstoodTurn {
  std::vector<std::string> acts = {};        // as text
  std::vector<std::string> explanation = {}; // a line each
};

struct HearingReport {
  std::string file;
  std::string recogniser;
  HeardFile heard;
  // One for each turn; empty if the application has nothing that could be
  // asked.
  std::vector<UnderstoodTurn> understood = {};
};

// Some lines for each turn, each with its end. `why` adds words and
// explanations.
std::string report_text(const HearingReport& report, bool why);
// As json_text() prints it.
Value report_value(const HearingReport& report);

} // namespace parlour::tools
