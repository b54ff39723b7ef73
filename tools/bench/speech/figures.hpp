// Figures with their bars, as the rows of the table print them.
#pragma once

#include <string>

namespace parlour::tools {

// "97.1 % (bar 95: met)".
std::string figure_at_least(double figure, double bar, const char* unit);
std::string figure_at_most(double figure, double bar, const char* unit);

} // namespace parlour::tools
