// `parlour bench nlu`: how much is understood, and how fast: of public data
// sets where they are, of names, and of what is said to an application.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "runtime/base/understanding.hpp"

namespace parlour::tools {

// The application that is measured.
struct NluApplication {
  UnderstandingModel model;
  ColumnReader columns;
  std::vector<GrammarModel> generic;
  std::vector<std::string> names; // of people that it knows
  std::vector<std::string> said;  // what visitors said to it
};

struct NluBenchOptions {
  std::string only;           // one row; empty: all
  std::filesystem::path data; // where the public data sets are; empty: nowhere
  bool validation = false;    // of them what was held out, instead of the test
};

// The names of the rows.
std::vector<std::string> nlu_bench_rows();

// False where something could not be measured; that is told in the table.
bool nlu_bench(const NluBenchOptions& options,
               const NluApplication& application, std::ostream& out);

} // namespace parlour::tools
