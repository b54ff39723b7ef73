// `parlour bench nlu`: how much is understood, and how fast. Its rows:
//
//  clinc …      public data sets, and sentences of a desk (data_rows)
//  names        names of people in the application's database
//  frames       sentences made from the application's grammars
//  application  what visitors have said to the application; speed and memory
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "adapters/nlu/understand/nlu_engine.hpp"
#include "runtime/message/understanding.hpp"

namespace parlour::tools {

// The application that is measured.
struct NluApplication {
  UnderstandingModel model;
  ColumnReader columns;
  // What it has of the platform.
  adapters::nlu::NluEngine::Options platform;
  // Names of people in its database.
  std::vector<std::string> names;
  // What visitors have said to it.
  std::vector<std::string> said;
};

struct NluBenchOptions {
  // The name of one row; empty: all.
  std::string only;
  // The folder of the public data sets; empty: they are not measured.
  std::filesystem::path data;
  // Measure the validation part instead of the test part. Settings are chosen
  // by it.
  bool validation = false;
};

// The names of the rows.
std::vector<std::string> nlu_bench_rows();

// Prints the table. False if something could not be measured.
bool nlu_bench(const NluBenchOptions& options,
               const NluApplication& application, std::ostream& out);

} // namespace parlour::tools
