// `parlour bench db`: queries of scripts, through the components, beside the
// databases' own libraries, as a table. The MariaDB server is one of its own.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> db_bench_rows();

// False where something could not be measured; that is told in the table.
bool db_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
