// Metrics as Prometheus reads them: its text format, version 0.0.4.
#pragma once

#include <string>

#include "runtime/base/metrics.hpp"

namespace parlour::adapters::web {

inline constexpr const char* metrics_content_type =
    "text/plain; version=0.0.4; charset=utf-8";

// Each metric with its HELP and TYPE lines; histograms in seconds.
std::string metrics_text(const Metrics& all);

} // namespace parlour::adapters::web
