// The commands: one function and one file each (x_command.cpp). Each returns
// the exit status. Answers go to `out`, everything about them to `err`.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"

namespace parlour::tools {

struct CheckOptions {
  std::string app; // an application, or one file
  bool json = false;
  bool fix = false; // what can safely be corrected
};
int check_command(const Places& places, const CheckOptions& options,
                  const Console& console);

struct TestOptions {
  std::string app;
  std::vector<std::string> files; // none: all of dialogues/
  std::string junit;              // a file; empty: none
  bool trace = false;             // of failures
  bool quiet = false;             // without coverage
  bool update = false;            // other words of the robot are right
  bool watch = false;             // again whenever a file changes
  unsigned jobs = 0;              // threads; 0: as many as cores
};
int test_command(const Places& places, const TestOptions& options,
                 const Console& console);

struct RunOptions {
  std::string app;
  bool text = false; // lines, also on a terminal
  bool trace = false;
  bool voice = false;
  bool fresh = false;             // databases made anew
  std::optional<Timestamp> clock; // virtual time from here
  std::optional<std::uint64_t> seed;
  std::string data; // empty: the default
};
int run_command(const Places& places, const RunOptions& options,
                const Console& console);

struct FormatOptions {
  std::vector<std::string> files; // "-": from standard input to the output
  bool check = false;             // only say which are not formatted
};
int format_command(const Places& places, const FormatOptions& options,
                   std::istream& in, const Console& console);

struct SchemaOptions {
  bool xsd = false;
};
int schema_command(const SchemaOptions& options, const Console& console);

struct HelpOptions {
  std::string name; // an element, function, role, attribute, event, or a word
  std::string page; // of the reference; empty: none
};
// `commands`: those of the program, for who has misspelt one.
int help_command(const HelpOptions& options,
                 const std::vector<std::string>& commands,
                 const Console& console);

struct ExecOptions {
  std::string file;     // a script, or an application
  bool listing = false; // show what it was compiled to, and run nothing
};
int exec_command(const Places& places, const ExecOptions& options,
                 const Console& console);

struct ComponentOptions {
  std::string plugin;
  std::string folder; // of its file; empty: part of the program
};
// Serves the plug-in to the program that started this one for it
// (adapters/process); nobody else has a use for it.
int component_command(const ComponentOptions& options, const Console& console);

struct BenchOptions {
  std::string name; // of benches(), or nlu
  int runs = 5;
  std::string only; // one row; empty: all
  std::string data; // a folder with public data sets, of nlu; empty: nowhere
  bool validation = false; // of nlu: what is held out, instead of the test
};
int bench_command(const BenchOptions& options, const Console& console);

// The understanding of the receptionist, and of public data sets.
int bench_nlu_command(const Places& places, const BenchOptions& options,
                      const Console& console);

struct UnderstandOptions {
  std::string app;
  std::string text;
  std::optional<Timestamp> clock; // what "tomorrow" counts from
};
int understand_command(const Places& places, const UnderstandOptions& options,
                       const Console& console);

} // namespace parlour::tools
