// The options of `parlour say` and `parlour listen`.
#pragma once

#include <CLI/CLI.hpp>

#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/run_flags.hpp"

namespace parlour::tools {

inline void add_say_flags(CLI::App& command, SayOptions& options) {
  command.add_option("TEXT", options.text, "What is said")->required();
  command
      .add_option("--voice", options.voice,
                  "Such as en-gb, or slt of FliteTTS; else the component's own")
      ->check(check_named);
  command
      .add_option("--component", options.component,
                  "Who speaks: a plug-in of the role TTS; else EspeakTTS")
      ->check(check_named);
  command.add_option("--option", options.options,
                     "NAME=VALUE, as often as there are some");
  auto* file = command
                   .add_option("-o,--output", options.file,
                               "A sound file; FLAC if it ends in .flac, else "
                               "WAV")
                   ->check(check_named)
                   ->type_name("FILE");
  command
      .add_option("--speaker", options.speaker,
                  "A device of ALSA; else the default one")
      ->check(check_named)
      ->excludes(file);
}

// APP is declared before.
inline void add_listen_flags(CLI::App& command, ListenOptions& options) {
  command.add_option("FILE", options.files, "Sound files: WAV, FLAC")
      ->required();
  command.add_flag("--why", options.why,
                   "Also each word, and why it is understood so");
  command.add_flag("--json", options.json, "As a JSON array");
}

} // namespace parlour::tools
