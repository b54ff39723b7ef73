// MetricsReport: what a running node has counted, as it is told to `parlour
// top`. Between the processes it is JSON.
#pragma once

#include <cstdint>
#include <string>

#include "runtime/base/clock.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/metrics.hpp"

namespace parlour::tools {

struct MetricsReport {
  std::string application; // its name
  std::string folder;      // absolute
  std::int64_t process = 0;
  Timestamp time = 0; // of the node
  Metrics metrics;
};

std::string to_json(const MetricsReport& report);
// An error where the text is no such report.
Expected<MetricsReport> metrics_from_json(const std::string& text);

} // namespace parlour::tools
