// Runs a program to its end.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace parlour::adapters::asr {

// What the program (found by PATH) writes when it reads `input`. Nothing if it
// cannot be started, fails, or has not ended in time; then it is ended. Blocks.
std::optional<std::string> program_output(const std::vector<std::string>& words,
                                          const std::string& input,
                                          std::chrono::milliseconds patience);

} // namespace parlour::adapters::asr
