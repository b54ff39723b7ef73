#include "tools/bench/speech/figures.hpp"

#include <fmt/format.h>

namespace parlour::tools {

namespace {

std::string with_bar(double figure, double bar, const char* unit, bool is_met) {
  return fmt::format("{:.1f}{} (bar {:g}: {})", figure, unit, bar,
                     is_met ? "met" : "missed");
}

} // namespace

std::string figure_at_least(double figure, double bar, const char* unit) {
  return with_bar(figure, bar, unit, figure >= bar);
}

std::string figure_at_most(double figure, double bar, const char* unit) {
  return with_bar(figure, bar, unit, figure <= bar);
}

} // namespace parlour::tools
