// `parlour bench components`: the cost of a message through a component's
// mailbox, compared with bare typed actors of CAF that do the same.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> component_bench_rows();

// Prints the table. False if something could not be measured.
bool component_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
