// A small script whose comments say what it does:
//
//   <!-- expect: text -->                   the next line printed
//   <!-- expect error at this line: text --> ends with an error of this line
//   <!-- expect finding at this line: text --> the compiler says so
//   <!-- compiles -->                       without a finding; it does not run
//
// The text of an error or finding needs to be a part of what is said. It runs
// as `parlour exec` would run it, in a time that only its waits move, with a
// data folder of its own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/script/script_run.hpp"

namespace parlour::test {

struct Expectation {
  std::string printed; // a line each
  std::vector<Remark> errors;
  std::vector<Remark> findings;
  bool compiles = false;

  bool empty() const {
    return printed.empty() && errors.empty() && findings.empty() && !compiles;
  }
};

Expectation read_expectation(const std::string& script);

// How a script is run; run_script() or another way to the same end.
using Runner = ScriptRun (*)(const std::shared_ptr<const script::Program>&,
                             std::uint64_t instructions,
                             const FileAccess& files);

// Compiles and runs the file; every difference from its margin is a failure.
void expect_as_in_margin(const std::filesystem::path& file,
                         Runner runner = run_script);

// Every case below tests/script/cases, sorted.
std::vector<std::filesystem::path> language_cases();
std::string name_of_case(const std::filesystem::path& file);

} // namespace parlour::test
