// The option --clock of a command.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "runtime/base/clock.hpp"

namespace parlour::tools {

// Adds the option, which is written to `clock`; that stays empty if the option
// is not given. Text that is no time is wrong usage.
inline void add_clock(CLI::App& command, std::optional<Timestamp>& clock,
                      const char* sentence) {
  const auto take = [&clock](const std::string& text) {
    const auto time = parse_timestamp(text);
    if (!time)
      throw CLI::ValidationError("--clock",
                                 "'" + text +
                                     "' is no time such as \"2026-11-21 "
                                     "09:00\"");
    clock = *time;
  };
  command.add_option_function<std::string>("--clock", take, sentence)
      ->type_name("TIME");
}

} // namespace parlour::tools
