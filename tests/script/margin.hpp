// Runs a language case: a script whose comments say what to expect.
//
//   <!-- expect: text -->                     the next line printed
//   <!-- expect error at this line: text -->  an error in this line
//   <!-- expect finding at this line: text --> a finding of the compiler here
//   <!-- compiles -->                         no findings; it is not run
//
// The text of an error or finding needs to be only a part of it. The script
// runs as with `parlour exec`, but in virtual time and with an empty data
// folder.
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

// How a script is run: run_script(), or another way with the same result.
using Runner = ScriptRun (*)(const std::shared_ptr<const script::Program>&,
                             std::uint64_t instructions,
                             const FileAccess& files);

// Compiles and runs the file. Each difference from its comments is a failure.
void expect_as_in_margin(const std::filesystem::path& file,
                         Runner runner = run_script);

// All cases below tests/script/cases, sorted.
std::vector<std::filesystem::path> language_cases();
std::string name_of_case(const std::filesystem::path& file);

} // namespace parlour::test
