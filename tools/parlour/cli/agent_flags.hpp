// The options of `parlour agent`.
#pragma once

#include <CLI/CLI.hpp>

#include "tools/parlour/cli/commands.hpp"

namespace parlour::tools {

inline void add_agent_flags(CLI::App& command, AgentOptions& options) {
  command.add_option("PLUGIN", options.plugin, "FILE.so, or a name")
      ->required();
  command
      .add_option("--connect", options.connect,
                  "Where the platform listens for lines: tcp://HOST:PORT, or "
                  "tls://HOST:PORT; else tcp://127.0.0.1:5671")
      ->type_name("ADDRESS");
  command.add_option("--name", options.name,
                     "The agent's name; else the plug-in's");
  command
      .add_option("--authority", options.authority,
                  "The certificate (PEM) that the platform's is checked "
                  "against; else those that the system trusts")
      ->type_name("FILE");
  command.add_option("--data", options.data,
                     "The plug-in's folder; else a temporary one");
  command.add_option("--option", options.options,
                     "NAME=VALUE, as often as there are some");
  command.footer("The agent's token, if it has one, is read from "
                 "$PARLOUR_TOKEN.");
}

inline void add_tap_flags(CLI::App& command, TapOptions& options) {
  command.add_option("BEGINNING", options.beginnings,
                     "Such as Robot. or Script.Goto; all messages if there is "
                     "none");
  command
      .add_option("--connect", options.connect,
                  "Where it publishes them; else 127.0.0.1:5673")
      ->type_name("HOST:PORT");
}

} // namespace parlour::tools
