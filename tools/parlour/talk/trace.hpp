// Inspections as lines for people: `--trace` and failed conversations.
#pragma once

#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/message/inspection.hpp"

namespace parlour::tools {

// One line for an inspection: its kind, what it is about, and for a message the
// way it took. docs/engine.md explains such lines.
//
//   message     ASR.RecognitionResult(hello, 1)  [session]
std::string trace_line(const Inspection& inspection);

// The text as one line: each run of line ends becomes one blank.
std::string as_one_line(std::string text);

} // namespace parlour::tools
