// `parlour bench db`: the cost of a script's query through a database
// component, compared with the same query through the database's own library.
// The MariaDB server is started for it.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// The names of the rows.
std::vector<std::string> db_bench_rows();

// Prints the table. False if something could not be measured.
bool db_bench(const BenchRows& wanted, std::ostream& out);

} // namespace parlour::tools
