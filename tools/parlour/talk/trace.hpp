// What is happening, as lines for people (`--trace`).
#pragma once

#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/inspection.hpp"

namespace parlour::tools {

// "message  ASR.RecognitionResult(hello, 1)  session". One line.
std::string trace_line(const Inspection& inspection);

// The text as one line: every run of line ends is one blank.
std::string as_one_line(std::string text);

} // namespace parlour::tools
