// The options of `parlour run` that need no reader of their own.
#pragma once

#include <CLI/CLI.hpp>

#include "tools/parlour/cli/commands.hpp"

namespace parlour::tools {

inline void add_run_flags(CLI::App& command, RunOptions& options) {
  command.add_flag("--text", options.text,
                   "A turn a line, bare, also on a terminal");
  command.add_flag("--fresh", options.fresh,
                   "Make the database anew from schema and seed; the old "
                   "file is kept as FILE.before");
  command.add_flag("--trace", options.trace,
                   "Show every message, transition and slot on stderr");
  command
      .add_option("--trace-actors", options.trace_actors,
                  "Show every message that these actors take: kinds such as "
                  "session, or names such as a component's")
      ->delimiter(',')
      ->type_name("NAME,...");
  auto* simulate =
      command.add_flag("--simulate", options.simulate,
                       "Let stand-ins take the places of remote agents");
  command
      .add_option("--agents", options.agents,
                  "Where remote agents connect, by lines of text, instead of "
                  "the settings' addresses; port 0: any that is free")
      ->type_name("HOST:PORT")
      ->excludes(simulate);
  command
      .add_option("--taps", options.taps,
                  "Where `parlour tap` listens to all messages, on this host")
      ->type_name("HOST:PORT");
  command.add_flag("--voice", options.voice,
                   "Microphone and speaker (not available yet)");
}

} // namespace parlour::tools
