// The tables that `parlour bench NAME` can print. `parlour bench nlu` is not
// among them: it needs an application (nlu/nlu_command.hpp).
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

// A table: its name, the names of its rows, and the function that measures
// them.
struct Bench {
  std::string name;
  std::vector<std::string> rows;
  // Prints the rows that are wanted. False if one of them could not be
  // measured; the table then says why.
  bool (*run)(const BenchRows& wanted, std::ostream& out);
};

const std::vector<Bench>& benches();

} // namespace parlour::tools
