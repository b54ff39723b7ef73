// The options of `parlour serve` and `parlour load`.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "tools/parlour/cli/clock_option.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/number_option.hpp"
#include "tools/parlour/cli/run_flags.hpp"

namespace parlour::tools {

// An option that takes a duration, such as 60s.
inline void add_duration(CLI::App& command, const char* name,
                         std::function<void(Milliseconds)> take,
                         const char* sentence) {
  command
      .add_option_function<std::string>(
          name,
          [name, take = std::move(take)](const std::string& given) {
            const auto read = parse_duration(given);
            if (!read)
              throw CLI::ValidationError(name, read.error().message);
            take(*read);
          },
          sentence)
      ->type_name("DURATION");
}

inline void add_serve_flags(CLI::App& command, ServeOptions& options) {
  add_number<std::uint16_t>(&command, "--port", {0, 65'535},
                            "Where visitors connect; 0: any that is free",
                            [&](auto port) { options.port = port; });
  command
      .add_option("--listen", options.address,
                  "An address of this machine; else 127.0.0.1, which nobody "
                  "reaches from elsewhere")
      ->type_name("ADDRESS");
  add_number<std::size_t>(&command, "--sessions", {1, 1'000'000},
                          "How many visitors there may be at a time; else 1000",
                          [&](auto most) { options.sessions = most; });
  add_duration(
      command, "--linger", [&](Milliseconds time) { options.linger = time; },
      "How long a session outlives its lost connection; else 60s");
  command
      .add_option("--origin", options.origins,
                  "Pages of this origin may connect, too, as often as there "
                  "are some")
      ->type_name("https://HOST");
  command.add_flag("--rehearsed", options.rehearsed,
                   "With the components of parlour test: nothing outside is "
                   "reached, and nothing is kept");
  add_journal_option(command, options.journal, options.strict);
  add_metrics_option(command, options.metrics);
  command
      .add_option("--data", options.data, "Folder of its database and files")
      ->check(check_named);
  add_number<std::uint64_t>(&command, "--seed",
                            {0, std::numeric_limits<std::uint64_t>::max()},
                            "Of all that is random, the same for each session",
                            [&](auto seed) { options.seed = seed; });
  add_clock(command, options.clock, "What its clock shows when it begins");
}

// What is wrong with the text as so many a second; "nan" is no number of them.
inline std::string check_rate(const std::string& text) {
  double rate = 0;
  return CLI::detail::lexical_cast(text, rate) && rate > 0 && rate <= 1e6
             ? ""
             : text + " is not more than 0 and at most 1000000";
}

inline void add_load_flags(CLI::App& command, LoadOptions& options) {
  command
      .add_option("APP", options.app,
                  "An application, or a folder of conversations")
      ->required();
  command.add_option("--to", options.to, "The server; else 127.0.0.1:4000")
      ->type_name("HOST:PORT");
  add_number<std::size_t>(&command, "--visitors", {1, 1'000'000},
                          "At a time; else 1",
                          [&](auto most) { options.visitors = most; });
  command
      .add_option("--rate", options.rate,
                  "Conversations that begin in a second; else each visitor "
                  "begins another when one is over")
      ->check(check_rate);
  command
      .add_option("--conversations", options.conversations,
                  "Of these names; else all")
      ->delimiter(',')
      ->type_name("NAME,...");
  add_duration(
      command, "--duration",
      [&](Milliseconds time) { options.duration = time; },
      "Until no more begin; else each visitor plays one");
  command.add_flag("--lines", options.by_lines, "By lines, not by WebSocket");
  command.add_flag("--idle", options.idle,
                   "Open sessions and say nothing: what they cost");
  add_clock(command, options.clock,
            "When the server's clock began; conversations of other times are "
            "left out");
}

} // namespace parlour::tools
