// The rows of `parlour bench nlu` that need a data set.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "adapters/nlu/understand/nlu_engine.hpp"
#include "tools/bench/nlu/nlu_data.hpp"

namespace parlour::tools {

struct DataRowOptions {
  std::filesystem::path folder; // empty: they are not measured
  DataPart part = DataPart::test;
  // Every row runs the component as an application loads it.
  adapters::nlu::NluEngine::Options platform;
};

std::vector<std::string> data_row_names();

// Prints one line, with what the nearest example reaches. False if the data
// could not be read or learnt.
bool data_row(const std::string& name, const DataRowOptions& options,
              std::ostream& out);

} // namespace parlour::tools
