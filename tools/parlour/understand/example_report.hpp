// What is to be said of an application's examples: which topics take each
// other's, which are too few or say the same again, and what to add.
#pragma once

#include <string>
#include <vector>

#include "adapters/nlu/understand/left_out.hpp"

namespace parlour::tools {

// A line for all, then some for each topic that could be better, the worst
// first. Empty: there are no examples.
std::vector<std::string>
example_report(const std::vector<adapters::nlu::LeftOutExample>& examples);

} // namespace parlour::tools
