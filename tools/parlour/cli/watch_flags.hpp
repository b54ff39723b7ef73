// The options of commands that concern a running application: `status`, `top`,
// `tail`, `reload`; and of those that let themselves be watched.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "runtime/base/text/host_and_port.hpp"
#include "tools/parlour/cli/commands.hpp"

namespace parlour::tools {

inline void add_status_flags(CLI::App& command, StatusOptions& options) {
  command.add_option("APP", options.app, "A name or folder; else all");
  command.add_flag("--json", options.json, "As a JSON array");
}

inline void add_top_flags(CLI::App& command, TopOptions& options) {
  command.add_option("APP", options.app,
                     "A name or folder; else the only one that runs");
  command.add_flag("--once", options.once,
                   "Print it once and end, as where no terminal is");
}

inline void add_tail_flags(CLI::App& command, TailOptions& options) {
  command.add_option("APP", options.app,
                     "A name or folder; else the only one that runs");
  command.add_option("--session", options.filter.session,
                     "Only of the session with this id");
  command
      .add_option("--kind", options.filter.kinds,
                  "Only of these kinds, as often as there are some")
      ->check(CLI::IsMember(inspection_kinds()));
  command
      .add_option("--from", options.filter.from,
                  "Only messages of this component or role")
      ->type_name("COMPONENT");
  command
      .add_option("--to-component", options.filter.to,
                  "Only messages for this component or role")
      ->type_name("COMPONENT");
}

inline void add_reload_flags(CLI::App& command, ReloadOptions& options) {
  command.add_option("APP", options.app,
                     "A name or folder; else the only one that runs");
  auto* const restart = command.add_flag("--restart", options.restart,
                                         "Conversations begin again");
  command
      .add_flag("--new-only", options.new_only,
                "Conversations that are going on keep the scripts that they "
                "have")
      ->excludes(restart);
  command.add_flag("--undo", options.undo,
                   "Back to the scripts before the last reload");
}

// The four, by the names on the command line.
struct WatchOptions {
  StatusOptions status;
  TopOptions top;
  TailOptions tail;
  ReloadOptions reload;
};
struct WatchCommand {
  const char* name;
  const char* sentence;
  int (*run)(const Places&, const WatchOptions&, const Console&);
  void (*add_flags)(CLI::App&, WatchOptions&);
};
inline constexpr WatchCommand watch_commands[] = {
    {"status", "How the actors of running nodes are",
     [](const Places& places, const WatchOptions& options,
        const Console& console) {
       return status_command(places, options.status, console);
     },
     [](CLI::App& command, WatchOptions& options) {
       add_status_flags(command, options.status);
     }},
    {"top", "Show how a running application does, each second",
     [](const Places& places, const WatchOptions& options,
        const Console& console) {
       return top_command(places, options.top, console);
     },
     [](CLI::App& command, WatchOptions& options) {
       add_top_flags(command, options.top);
     }},
    {"tail", "Follow what happens in a running application",
     [](const Places& places, const WatchOptions& options,
        const Console& console) {
       return tail_command(places, options.tail, console);
     },
     [](CLI::App& command, WatchOptions& options) {
       add_tail_flags(command, options.tail);
     }},
    {"reload", "Take a running application over to its changed files",
     [](const Places& places, const WatchOptions& options,
        const Console& console) {
       return reload_command(places, options.reload, console);
     },
     [](CLI::App& command, WatchOptions& options) {
       add_reload_flags(command, options.reload);
     }}};

// "9464", or "0.0.0.0:9464".
inline std::optional<HostAndPort> read_pages_address(const std::string& text) {
  const bool is_port = text.find(':') == std::string::npos;
  return read_host_and_port(is_port ? "127.0.0.1:" + text : text);
}

inline CLI::Option* add_metrics_option(CLI::App& command,
                                       std::optional<HostAndPort>& metrics) {
  return command
      .add_option_function<std::string>(
          "--metrics",
          [&metrics](const std::string& given) {
            metrics = read_pages_address(given);
            if (!metrics)
              throw CLI::ValidationError("--metrics",
                                         "'" + given +
                                             "' is neither a port nor an "
                                             "address with a port");
          },
          "Tell Prometheus what is counted, at /metrics over HTTP, and at "
          "/health how it is; only this machine unless an address is given; "
          "port 0: any that is free")
      ->type_name("[ADDRESS:]PORT");
}

} // namespace parlour::tools
