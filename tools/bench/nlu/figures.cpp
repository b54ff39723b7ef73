#include "tools/bench/nlu/figures.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

using adapters::nlu::NluEngine;

const char* met(bool ok) {
  return ok ? "met" : "missed";
}

std::string at_least(double figure, double bar, const char* unit) {
  return fmt::format("{:.1f}{} (bar {:g}: {})", figure, unit, bar,
                     met(figure >= bar));
}

std::string at_most(double figure, double bar, const char* unit) {
  return fmt::format("{:.1f}{} (bar {:g}: {})", figure, unit, bar,
                     met(figure <= bar));
}

Expected<TrainedEngine> train(const UnderstandingModel& model,
                              const ColumnReader& columns,
                              NluEngine::Options options) {
  const auto bytes = bytes_in_use();
  const auto start = cpu_nanoseconds();
  auto built = NluEngine::build(model, columns, std::move(options));
  const auto taken = cpu_nanoseconds() - start;
  if (!built)
    return tl::make_unexpected(built.error().front());
  const auto more = bytes_in_use() - std::min(bytes, bytes_in_use());
  return TrainedEngine{std::move(*built), taken / 1e6,
                       double(more) / (1 << 20)};
}

} // namespace parlour::tools
