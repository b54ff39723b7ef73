// Every table that `parlour bench` can print.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "tools/bench/support/measure.hpp"

namespace parlour::tools {

struct Bench {
  std::string name;
  std::vector<std::string> rows;
  // False where something could not be measured; that is told in the table.
  bool (*run)(const BenchRows& wanted, std::ostream& out);
};

const std::vector<Bench>& benches();

} // namespace parlour::tools
