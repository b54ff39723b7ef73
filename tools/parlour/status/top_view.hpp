// TopView: what `parlour top` shows of a running node.
#pragma once

#include <optional>
#include <string>

#include "tools/parlour/status/metrics_report.hpp"

namespace parlour::tools {

// A table of several lines. Rates and times are those since `before`; without,
// since the application was started.
std::string top_view(const MetricsReport& now,
                     const std::optional<MetricsReport>& before = {});

} // namespace parlour::tools
