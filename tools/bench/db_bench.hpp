// `parlour bench db`: queries of scripts, through the components, beside the
// databases' own libraries, as a table. The MariaDB server is one of its own.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace parlour::tools {

struct DbBenchOptions {
  int runs = 5;     // of each; their median counts
  std::string only; // one row; empty: all
};

// The names of the rows.
std::vector<std::string> db_bench_rows();

// False where something could not be measured; that is told in the table.
bool db_bench(const DbBenchOptions& options, std::ostream& out);

} // namespace parlour::tools
