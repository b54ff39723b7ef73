// `parlour bench platform`: many conversations at once in one process. What it
// takes to open one, what it keeps, and how many turns are answered.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

#include "tools/parlour/application/application.hpp"
#include "tools/parlour/console/console.hpp"

namespace parlour::tools {

struct PlatformBenchOptions {
  std::size_t sessions = 10'000;
  std::string only; // one row; empty: all
};

// The names of the rows.
std::vector<std::string> platform_bench_rows();

// Measures the receptionist of `places`. False if it could not be measured, or
// if a visitor was told something else than the others.
bool platform_bench(const Places& places, const PlatformBenchOptions& options,
                    const Console& console);

} // namespace parlour::tools
