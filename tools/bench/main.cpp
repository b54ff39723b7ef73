// The program parlour-bench, to which `parlour bench` passes its arguments.
#include <iostream>

#include "tools/bench/command_line.hpp"

int main(int count, char** arguments) {
  using namespace parlour::tools;
  return run_bench_command_line({arguments + 1, arguments + count},
                                process_places(), {std::cout, std::cerr});
}
