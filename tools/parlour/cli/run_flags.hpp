// The options of commands that need no reader of their own.
#pragma once

#include <limits>

#include <CLI/CLI.hpp>

#include "tools/parlour/application/voice.hpp"
#include "tools/parlour/cli/clock_option.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/cli/component_page.hpp"
#include "tools/parlour/cli/journal_commands.hpp"
#include "tools/parlour/cli/number_option.hpp"
#include "tools/parlour/cli/plugins/plugin_commands.hpp"
#include "tools/parlour/cli/watch_flags.hpp"

namespace parlour::tools {

// For CLI::Option::check(). An empty name usually comes from an unset shell
// variable.
inline std::string check_named(const std::string& text) {
  return text.empty() ? "an empty name" : "";
}

// Returned is --strict.
inline CLI::Option* add_journal_option(CLI::App& command, std::string& folder,
                                       bool& strict) {
  auto* journal =
      command
          .add_option("--journal", folder,
                      "Keep all that enters the conversations, also what is "
                      "private: a run that is killed goes on, and `parlour "
                      "replay` repeats them")
          ->check(check_named)
          ->type_name("FOLDER");
  return command
      .add_flag("--strict", strict,
                "Say and do nothing before it is in the journal, on the disk")
      ->needs(journal);
}

inline void add_voice_flags(CLI::App& command, RunOptions& options) {
  auto* voice = command.add_flag("--voice", options.voice,
                                 "Talk by microphone and speaker, too");
  command
      .add_option("--microphone", options.microphone,
                  "With --voice: a device of ALSA, or a file to hear")
      ->type_name("DEVICE|FILE.wav")
      ->needs(voice);
  command
      .add_option("--speaker", options.speaker,
                  "With --voice: a device of ALSA, or a file to write")
      ->type_name("DEVICE|FILE.wav")
      ->needs(voice);
  auto* by_key =
      command
          .add_flag("--push-to-talk", options.push_to_talk,
                    "With --voice: a key of the terminal begins and ends a "
                    "turn; =/dev/input/eventN: a key of this device")
          ->transform([](const std::string& given) {
            return given == "true" ? terminal_key : given;
          })
          ->needs(voice);
  command
      .add_option("--talk-key", options.talk_key,
                  "Which key: space, f5, k, code-164, any; else space")
      ->check(check_named)
      ->needs(by_key);
  command
      .add_option("--wake", options.wake,
                  "With --voice: sleeps until one of these words is said, and "
                  "again after 10 s of silence")
      ->check(check_named)
      ->type_name("WORD,...")
      ->needs(voice)
      ->excludes(by_key);
}

inline void add_run_flags(CLI::App& command, RunOptions& options) {
  add_clock(command, options.clock,
            "Virtual time from here; an empty line steps to the next timer");
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
  add_journal_option(command, options.journal, options.strict)
      ->excludes(command.get_option("--clock"));
  // Not with --clock, which run_command says: CLI11 lists several options that
  // exclude one in an order of its own each time.
  add_metrics_option(command, options.metrics);
  command
      .add_option("--data", options.data, "Folder of its database and files")
      ->check(check_named);
  add_number<std::uint64_t>(
      &command, "--seed", {0, std::numeric_limits<std::uint64_t>::max()},
      "Of all that is random", [&](auto seed) { options.seed = seed; });
  add_voice_flags(command, options);
}

inline void add_check_flags(CLI::App& command, CheckOptions& options) {
  command.add_flag("--json", options.json,
                   "Findings as a JSON array of {file, line, column, end, "
                   "kind, name, message, fix}");
  command.add_flag("--fix", options.fix,
                   "Correct in the files what can safely be corrected");
  command
      .add_flag("--examples", options.examples,
                "Read each example as if it were not there: which topics are "
                "taken for each other, what to add")
      ->excludes("--json");
}

inline void add_journal_flags(CLI::App& command, std::string_view name,
                              JournalOptions& options) {
  const bool exports = name == "export";
  if (exports)
    command.add_option("APP", options.app, "The application that held them")
        ->required();
  command.add_option("JOURNAL", options.journal, "Its folder")->required();
  if (!exports)
    return;
  command.add_option("SESSION", options.session, "Its id; else all");
  command
      .add_option("--as", options.as,
                  "test: for parlour test; transcript; json: an object a line")
      ->check(CLI::IsMember({"test", "transcript", "json"}));
}

inline void add_new_plugin_flags(CLI::App& command, NewPluginOptions& options) {
  command.add_option("NAME", options.name, "Such as EchoTTS")->required();
  command.add_option("--role", options.role, "Such as TTS")->required();
  command.add_option("--folder", options.folder, "Where; else ./NAME")
      ->check(check_named);
}

inline void add_test_plugin_flags(CLI::App& command,
                                  TestPluginOptions& options) {
  command.add_option("PLUGIN", options.plugin, "FILE.so, or a name")
      ->required();
  command.add_option("--option", options.options,
                     "NAME=VALUE, as often as there are some");
  add_number<int>(
      &command, "--load-seconds", {0, 50},
      "How long after its start it may load what it needs; else 15",
      [&](int time) { options.load_time = std::chrono::seconds(time); });
}

inline void add_exec_flags(CLI::App& command, ExecOptions& options) {
  command.add_option("FILE", options.file, "A script or app")->required();
  command.add_flag("--listing", options.listing, "Show its compiled code");
}

inline void add_component_flags(CLI::App& command, ComponentOptions& options) {
  command.group(""); // not shown
  command.add_option("PLUGIN", options.plugin, "Its plug-in")->required();
  command.add_option("--plugins", options.folder, "Its file's folder");
}

inline void add_help_flags(CLI::App& command, HelpOptions& options) {
  command.add_option("NAME", options.name,
                     "Such as speak, format, TTS; an attribute, an event, or a "
                     "word to look for");
  command.add_option("--page", options.page, "A page of the reference")
      ->check(CLI::IsMember(help_pages()))
      ->group(""); // not shown
}

inline void add_replay_flags(CLI::App& command, ReplayOptions& options) {
  command
      .add_option("JOURNAL", options.journal,
                  "A folder that `parlour run --journal` has written")
      ->required();
  command.add_option("SESSION", options.session, "Its id; else all");
  add_number<std::size_t>(&command, "--until",
                          {0, std::numeric_limits<std::size_t>::max()},
                          "So many inputs of each session; else all",
                          [&](std::size_t inputs) { options.until = inputs; });
  command.add_flag("--trace", options.trace,
                   "Also every transition, topic and slot");
}

inline void add_test_flags(CLI::App& command, TestOptions& options) {
  command.add_option("FILE", options.files,
                     "Conversations; all of dialogues/ if there is none");
  command.add_option("--junit", options.junit, "Results as JUnit's XML")
      ->check(check_named)
      ->type_name("FILE");
  command.add_flag("--trace", options.trace,
                   "Show what happened in those that failed");
  command.add_flag("--quiet,-q", options.quiet, "Leave out the coverage");
  command.add_flag("--update", options.update,
                   "Write what the robot says now into the conversations");
  command.add_flag("--watch", options.watch, "Again when a file changes")
      ->excludes("--junit");
  command.add_flag("--restore-after-each-input", options.restores)->group("");
  add_number<unsigned>(&command, "--jobs,-j", {1, 1000},
                       "Conversations at a time; else as many as cores",
                       [&](auto jobs) { options.jobs = jobs; });
  auto* voice = command
                    .add_flag("--voice", options.voice,
                              "Hold them by voice, and compare with text")
                    ->excludes("--junit")
                    ->excludes("--update")
                    ->excludes("--watch");
  command
      .add_option("--voices", options.voices,
                  "With --voice: who speaks, voices of flite or espeak-ng; "
                  "else rms")
      ->delimiter(',')
      ->type_name("NAME,...")
      ->needs(voice);
  command
      .add_option("--noise", options.noise,
                  "With --voice: pink, white or babble, and how many dB the "
                  "speech is louder, such as babble@20")
      ->type_name("NOISE@DB")
      ->needs(voice);
  command
      .add_option("--recogniser", options.recogniser,
                  "With --voice: the plug-in that hears")
      ->type_name("PLUGIN")
      ->needs(voice);
  command
      .add_flag("--told", options.told,
                "With --voice: the recogniser knows what is said in the "
                "conversations, as it does in a run")
      ->needs(voice);
}

inline void add_understand_flags(CLI::App& command,
                                 UnderstandOptions& options) {
  command.add_option("TEXT", options.text, "What somebody says");
  command.add_flag("--batch", options.batch,
                   "Read a sentence a line, and write a line of JSON for each");
  command
      .add_option("--score", options.score,
                  "Compare with marked sentences, a line of JSON each")
      ->type_name("FILE")
      ->check(check_named);
  command
      .add_option("--context", options.context,
                  "What was asked, as JSON: {\"asked\": {\"topic\": \"Taxi\", "
                  "\"slot\": \"Time\"}}")
      ->type_name("JSON");
  add_clock(command, options.clock, "The time that \"tomorrow\" counts from");
}

inline void add_format_flags(CLI::App& command, FormatOptions& options) {
  command
      .add_option("FILE", options.files,
                  "Scripts, laid out where they are; - reads standard input "
                  "and writes standard output")
      ->required();
  command.add_flag("--check", options.check,
                   "Change nothing; status 1 where a file is not laid out");
}

inline void add_devices_flags(CLI::App& command, DevicesOptions& options) {
  auto* test =
      command.add_flag("--test", options.test,
                       "Play a tone, then show how loud the microphone is");
  command
      .add_option("--microphone", options.microphone,
                  "The one to try; else the default one")
      ->check(check_named)
      ->needs(test);
  command
      .add_option("--speaker", options.speaker,
                  "The one to try; else the default one")
      ->check(check_named)
      ->needs(test);
  add_number<int>(&command, "--seconds", {1, 600}, "How long to listen; else 5",
                  [&](int time) { options.time = std::chrono::seconds(time); });
}

} // namespace parlour::tools
