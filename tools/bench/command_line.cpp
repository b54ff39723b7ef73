#include "tools/bench/command_line.hpp"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "tools/bench/benches.hpp"
#include "tools/bench/nlu/nlu_command.hpp"
#include "tools/bench/platform/platform_bench.hpp"
#include "tools/bench/speech/speech_bench.hpp"
#include "tools/parlour/cli/number_option.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

// What the command line asks for.
struct BenchOptions {
  // A name of benches(), or "nlu".
  std::string name;
  BenchRows rows;
  // Of the table nlu: the folder with the public data sets. Empty: rows that
  // need one say so.
  std::string data;
  // Measure with the validation part of the data sets, and not with the test.
  bool validation = false;
  // Of the table platform: how many conversations are open.
  std::size_t sessions = 10'000;
  SpeechBenchOptions speech;
};

using Run = std::function<bool(const BenchOptions&)>;

// One table: the rows that it has, and how it is measured.
struct Table {
  std::vector<std::string> rows;
  Run run;
};

// `name` has been checked against names(). The table refers to the arguments.
Table table_of(const std::string& name, const Places& places,
               const Console& console) {
  if (name == "nlu")
    return {nlu_bench_rows(), [&](const BenchOptions& options) {
              return nlu_command(
                  places, {options.rows.only, options.data, options.validation},
                  console);
            }};
  if (name == "platform")
    return {platform_bench_rows(), [&](const BenchOptions& options) {
              return platform_bench(
                  places, {options.sessions, options.rows.only}, console);
            }};
  if (name == "speech")
    return {speech_bench_rows(), [&](const BenchOptions& options) {
              auto speech = options.speech;
              speech.only = options.rows.only;
              speech.data = options.data;
              return speech_bench(places, speech, console);
            }};
  const auto& bench = *std::ranges::find(benches(), name, &Bench::name);
  return {bench.rows, [&](const BenchOptions& options) {
            return bench.run(options.rows, console.out);
          }};
}

std::vector<std::string> names() {
  std::vector<std::string> names{"nlu", "platform", "speech"};
  for (const auto& bench : benches())
    names.push_back(bench.name);
  return names;
}

void add_speech_options(CLI::App& app, SpeechBenchOptions& options) {
  app.add_option("--recogniser", options.recogniser,
                 "Of the table speech: a plug-in of the role ASR; else the one "
                 "that a run takes");
  app.add_option("--voices", options.voices, "Who speaks; else rms,slt")
      ->delimiter(',');
  app.add_option("--speakers", options.speakers,
                 "Whose recordings are heard; else jackson,nicolas")
      ->delimiter(',');
  app.add_flag("--told", options.told,
               "The recogniser knows what is said in dialogues/");
  add_number<std::size_t>(&app, "--one-in", {1, 1000},
                          "Of names and conversations one in so many; else 1",
                          [&](auto step) { options.one_in = step; });
  app.add_flag("--trace", options.trace, "Prints what was heard");
}

void add_options(CLI::App& app, BenchOptions& options) {
  app.add_option("NAME", options.name, "What is measured")
      ->required()
      ->check(CLI::IsMember(names()));
  add_number<int>(&app, "--runs", {1, 1000},
                  "Of each; the median counts; else 5",
                  [&](auto runs) { options.rows.runs = runs; });
  app.add_option("--only", options.rows.only, "One row of the table");
  add_number<int>(&app, "--agents", {1, 4000},
                  "Of the table agents: how many connect; else 1000",
                  [&](auto agents) { options.rows.agents = agents; });
  add_number<int>(&app, "--seconds", {1, 86'400},
                  "Of the table agents: how long audio lasts; else 60",
                  [&](auto seconds) { options.rows.seconds = seconds; });
  add_number<std::size_t>(
      &app, "--sessions", {10, 1'000'000},
      "Of the table platform: how many conversations are open; else 10000",
      [&](auto sessions) { options.sessions = sessions; });
  app.add_option("--data", options.data,
                 "Where the public data sets of nlu are, or the recordings of "
                 "speech");
  app.add_flag("--validation", options.validation,
               "Of them what is held out of training, not the test");
  add_speech_options(app, options.speech);
}

// An unknown row is a mistake of usage, which lists the rows that there are.
int run_table(const BenchOptions& options, const Places& places,
              const Console& console) {
  const auto table = table_of(options.name, places, console);
  const auto& only = options.rows.only;
  if (!only.empty() && std::ranges::count(table.rows, only) == 0) {
    say_error(console, "bench " + options.name + " has no row '" + only +
                           "'; it has " + CLI::detail::join(table.rows, ", "));
    return exit_code::usage;
  }
  return table.run(options) ? exit_code::success : exit_code::wrong;
}

} // namespace

int run_bench_command_line(std::vector<std::string> arguments,
                           const Places& places, const Console& console) {
  CLI::App app("Measures Parlour beside others who do the same work",
               "parlour bench");
  BenchOptions options;
  add_options(app, options);
  // CLI11 expects the arguments in reverse order.
  std::ranges::reverse(arguments);
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& error) {
    return app.exit(error, console.out, console.err) == 0 ? exit_code::success
                                                          : exit_code::usage;
  }
  return run_table(options, places, console);
}

} // namespace parlour::tools
