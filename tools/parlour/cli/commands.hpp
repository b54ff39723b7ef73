// The commands of `parlour`, one function and one file (x_command.cpp) each.
//
// A command gets its options already parsed and checked for form, the search
// paths (Places) and the streams (Console), and returns the exit status
// (exit_code.hpp). It prints its result to `console.out`, and errors, warnings
// and progress to `console.err`. No command throws for what a user can cause.
// Applications and scripts are looked up from `places.working`.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/clock.hpp"
#include "runtime/base/text/host_and_port.hpp"
#include "tools/parlour/console/console.hpp"
#include "tools/parlour/console/places.hpp"
#include "tools/parlour/status/tail_filter.hpp"

namespace parlour::tools {

// `parlour check`: prints everything that is wrong with an application or with
// one script file. `json` prints an array for editors instead of lines. `fix`
// corrects the files where that is safe and prints what remains (fix.hpp).
struct CheckOptions {
  std::string app; // a folder, an application's name, or a script
  bool json = false;
  bool fix = false;      // apply the safe corrections
  bool examples = false; // tell, too, what could be better about the examples
};
int check_command(const Places& places, const CheckOptions& options,
                  const Console& console);

// `parlour test`: runs the conversations of an application in virtual time and
// compares what the robot says (docs/test.md).
struct TestOptions {
  std::string app;
  std::vector<std::string> files; // empty: all of dialogues/
  std::string junit;              // file for JUnit XML; empty: none
  bool trace = false;             // print the trace of each failure
  bool quiet = false;             // leave out the coverage
  bool update = false;            // accept other words, rewrite the files
  bool watch = false;             // run again whenever a file changes
  bool restores = false;          // save and restore after each input
  unsigned jobs = 0;              // threads; 0: one for each core
  bool voice = false;             // hold them by voice (docs/speech.md)
  std::vector<std::string> voices = {"rms"};
  std::string noise;      // behind the user: "babble@20"; empty: none
  std::string recogniser; // a plug-in; empty: the application's, or the best
  bool told = false;      // the recogniser knows the conversations
};
int test_command(const Places& places, const TestOptions& options,
                 const Console& console);

// `parlour run`: talks with an application on a terminal or by piped lines
// (docs/running.md).
struct RunOptions {
  std::string app;
  bool text = false; // plain lines even on a terminal
  // Show every message, transition and slot on standard error.
  bool trace = false;
  std::vector<std::string> trace_actors; // kinds or names
  // Microphone and speaker: devices or files; empty: the default ones.
  bool voice = false;
  std::string microphone;
  std::string speaker;
  // Turns by a key: "terminal" or an input device; empty: by what is heard.
  std::string push_to_talk;
  std::string talk_key;  // its name; empty: space
  std::string wake;      // words that wake it; empty: as the settings say
  bool fresh = false;    // make the SQLite databases anew
  bool simulate = false; // stand-ins in the place of remote agents
  // Where agents connect by lines, and nowhere else; empty: as the settings
  // say.
  std::string agents;
  // Where taps listen; empty: as the settings say.
  std::string taps;
  std::optional<Timestamp> clock; // virtual time starts here
  // Seed for everything random; without one, each run differs.
  std::optional<std::uint64_t> seed;
  std::string data; // data folder; empty: the default
  // The folder where what enters the sessions is kept; empty: nowhere.
  std::string journal;
  bool strict = false; // nothing leaves a session before its journal has it
  std::optional<HostAndPort> metrics; // where they are told; nothing: nowhere
};
int run_command(const Places& places, const RunOptions& options,
                const Console& console);

// `parlour serve`: an application for many visitors, by lines and WebSocket
// (docs/operations.md).
struct ServeOptions {
  std::string app;
  std::string address = "127.0.0.1";
  std::uint16_t port = 4'000;
  std::size_t sessions = 1'000;
  Milliseconds linger{60'000};
  std::vector<std::string> origins;
  bool rehearsed = false;         // with the components of `parlour test`
  std::optional<Timestamp> clock; // what its clock shows at the beginning
  std::optional<std::uint64_t> seed;
  std::string data;
  std::string journal; // a folder; empty: nothing is kept
  bool strict = false;
  std::optional<HostAndPort> metrics; // where they are told; nothing: nowhere
};
int serve_command(const Places& places, const ServeOptions& options,
                  const Console& console);

// `parlour reload`: takes a running application over to its changed files, or
// back (docs/operations.md).
struct ReloadOptions {
  std::string app; // a name or folder; empty: the only one that runs
  bool restart = false;
  bool new_only = false;
  bool undo = false;
};
int reload_command(const Places& places, const ReloadOptions& options,
                   const Console& console);

// `parlour load`: plays an application's conversations as visitors of `parlour
// serve`, checks the answers and tells how fast they come (docs/operations.md).
struct LoadOptions {
  std::string app; // or a folder of conversations
  std::string to = "127.0.0.1:4000";
  std::size_t visitors = 1;
  std::optional<double> rate; // conversations a second; nothing: closed loop
  std::vector<std::string> conversations; // names; empty: all
  std::optional<Milliseconds> duration;
  std::optional<Timestamp> clock; // of the server; else that of tests
  bool by_lines = false;          // else by WebSocket
  bool idle = false;              // open sessions and say nothing
};
int load_command(const Places& places, const LoadOptions& options,
                 const Console& console);

// `parlour replay`: repeats the sessions of a journal, word by word, and tells
// at which input one differs (docs/running.md).
struct ReplayOptions {
  std::string app;
  std::string journal;              // a folder of `parlour run --journal`
  std::string session;              // empty: all
  std::optional<std::size_t> until; // so many inputs; nothing: all
  bool trace = false;
};
int replay_command(const Places& places, const ReplayOptions& options,
                   const Console& console);

// `parlour agent`: runs a plug-in as a remote agent of a platform elsewhere,
// until a signal comes, the plug-in fails, or the platform does not want it.
struct AgentOptions {
  std::string plugin; // a file NAME.so, or a plug-in's name
  std::string connect = "tcp://127.0.0.1:5671";
  std::string name; // empty: the plug-in's
  std::string authority;
  std::string data;                 // empty: a temporary folder
  std::vector<std::string> options; // "name=value"
};
int agent_command(const Places& places, const AgentOptions& options,
                  const Console& console);

// `parlour tap`: prints the messages of a running application, until a signal
// comes (docs/agents.md).
struct TapOptions {
  std::vector<std::string> beginnings; // of "source.command"; empty: all
  std::string connect = "127.0.0.1:5673";
};
int tap_command(const TapOptions& options, const Console& console);

// `parlour devices`: lists microphones, speakers and what hears and speaks with
// them; tries a speaker by a tone and a microphone by showing its level.
struct DevicesOptions {
  bool test = false;
  std::string microphone = "default"; // names of ALSA
  std::string speaker = "default";
  Milliseconds time{5'000}; // of listening
};
int devices_command(const DevicesOptions& options, const Console& console);

// `parlour say`: speaks a text by a component of the role TTS.
struct SayOptions {
  std::string text;
  std::string component = "EspeakTTS"; // a plug-in's name, or a file NAME.so
  std::string voice;                   // empty: the component's own
  std::vector<std::string> options;    // "name=value"
  std::string file;                    // WAV or FLAC; empty: the speaker
  std::string speaker = "default";     // a name of ALSA
};
int say_command(const Places& places, const SayOptions& options,
                const Console& console);

// `parlour listen`: what each component of an application that talks by voice
// makes of sound files, and what is understood.
struct ListenOptions {
  std::string app;
  std::vector<std::string> files;
  bool why = false; // also words and explanations
  bool json = false;
};
int listen_command(const Places& places, const ListenOptions& options,
                   const Console& console);

// `parlour status`: tells how the actors of running applications are.
struct StatusOptions {
  std::string app; // its name or folder; empty: all that run
  bool json = false;
};
// How the actors of running applications are.
int status_command(const Places& places, const StatusOptions& options,
                   const Console& console);

// `parlour top`: how a running application does, again each second
// (docs/operations.md).
struct TopOptions {
  std::string app; // its name or folder; empty: the only one that runs
  bool once = false;
};
int top_command(const Places& places, const TopOptions& options,
                const Console& console);

// `parlour tail`: what happens in a running application, until a signal comes
// or the application ends.
struct TailOptions {
  std::string app; // as above
  TailFilter filter;
};
int tail_command(const Places& places, const TailOptions& options,
                 const Console& console);

struct FormatOptions {
  std::vector<std::string> files; // "-": standard input to output
  bool check = false;             // only report unformatted files
};
int format_command(const Places& places, const FormatOptions& options,
                   std::istream& in, const Console& console);

// `parlour schema`: prints the schema of the script language for XML editors,
// RELAX NG or XML Schema (docs/editors.md).
struct SchemaOptions {
  bool xsd = false;
};
int schema_command(const SchemaOptions& options, const Console& console);

// `parlour help`: explains an element, function, role, attribute or event, or
// lists what mentions a word. `page` prints a whole page of docs/reference.
struct HelpOptions {
  std::string name; // what to explain; any word is allowed
  std::string page; // a page's name; empty: none
};
// `commands` are the names of the program's commands. They are candidates for
// "did you mean", and a name that is both a command and an element gets a hint
// at `parlour NAME --help`.
int help_command(const HelpOptions& options,
                 const std::vector<std::string>& commands,
                 const Console& console);

// `parlour exec`: runs the function `main` of a script in real time, without a
// dialogue. `listing` prints the compiled instructions and runs nothing.
struct ExecOptions {
  std::string file; // a script file or an application
  // Print the compiled code instead of running it.
  bool listing = false; // show what it was compiled to, and run nothing
};
int exec_command(const Places& places, const ExecOptions& options,
                 const Console& console);

// `parlour component`: the child process of a component with host="process".
struct ComponentOptions {
  std::string plugin;
  std::string folder; // of its file; empty: built in
};
// Serves the plug-in over a socket that the parent has opened
// (adapters/process). Hidden: the program starts it, never a user.
int component_command(const ComponentOptions& options, const Console& console);

// `parlour bench`: replaces this process by the program parlour-bench, which is
// built on request (tools/bench/run). `arguments` are those of `parlour bench`.
int bench_command(const std::vector<std::string>& arguments,
                  const Places& places, const Console& console);

// `parlour keygen`: makes a pair of keys for remote agents over ZeroMQ. Writes
// the secret one to a new file that only its owner may read, and prints the
// public one with the line of settings that names it.
int keygen_command(const Places& places, const std::string& file,
                   const Console& console);

// `parlour understand`: prints how the application's GrammarNLU understands a
// text, and why.
struct UnderstandOptions {
  std::string app;
  std::string text;
  bool batch = false;             // the sentences of standard input
  std::string score;              // a file of marked sentences
  std::string context;            // JSON
  std::optional<Timestamp> clock; // "now" for "tomorrow"; else the clock
};
int understand_command(const Places& places, const UnderstandOptions& options,
                       const Console& console);

} // namespace parlour::tools
